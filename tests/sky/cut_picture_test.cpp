// SPDX-License-Identifier: Apache-2.0
// Cut and damaged pictures of every format that libraries decode: each prefix is refused, whatever the library made of
// it, and the texels of an accepted picture do not depend on the memory before.
#include <OpenImageIO/imageio.h>
#include <jpeglib.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sky/base/error.h"
#include "sky/image/coded_image.h"
#include "sky/image/image.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

using OIIO::TypeDesc;
constexpr int kWidth = 48, kHeight = 40;

/// A picture without repetition, so that no codec makes its end redundant.
std::vector<float> noise() {
  std::vector<float> value;
  std::uint32_t state = 1;
  for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
    state = state * 1664525U + 1013904223U;
    value.push_back(static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U));
  }
  return value;
}

std::string written(const std::string& name, TypeDesc type,
                    const std::vector<std::pair<std::string, std::string>>& set) {
  const Folder folder;
  auto output = OIIO::ImageOutput::create(name);
  REQUIRE(output);
  OIIO::ImageSpec spec(kWidth, kHeight, 3, type);
  for (const auto& [key, value] : set)
    if (key == "tile")
      spec.tile_width = spec.tile_height = 16;
    else
      spec.attribute(key, value);
  spec.attribute("tiff:RowsPerStrip", 8);
  REQUIRE(output->open(folder / name, spec));
  REQUIRE(output->write_image(TypeDesc::FLOAT, noise().data()));
  REQUIRE(output->close());
  return readBytes(folder / name);
}

std::string jpeg(bool progressive) {
  jpeg_compress_struct state{};
  jpeg_error_mgr errors{};
  state.err = jpeg_std_error(&errors);
  jpeg_create_compress(&state);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&state, &buffer, &size);
  state.image_width = kWidth;
  state.image_height = kHeight;
  state.input_components = 3;
  state.in_color_space = JCS_RGB;
  jpeg_set_defaults(&state);
  if (progressive) jpeg_simple_progression(&state);
  jpeg_start_compress(&state, TRUE);
  std::vector<unsigned char> row(3 * kWidth);
  const std::vector<float> value = noise();
  while (state.next_scanline < state.image_height) {
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = static_cast<unsigned char>(255.0F * value[state.next_scanline * row.size() + i]);
    unsigned char* line = row.data();
    jpeg_write_scanlines(&state, &line, 1);
  }
  jpeg_finish_compress(&state);
  std::string bytes(reinterpret_cast<const char*>(buffer), size);
  jpeg_destroy_compress(&state);
  std::free(buffer);
  return bytes;
}

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> samples() {
  std::vector<Sample> all = {{"baseline.jpg", jpeg(false)}, {"progressive.jpg", jpeg(true)}};
  for (const char* packing : {"none", "lzw", "zip", "packbits"})
    for (const TypeDesc& type : {TypeDesc(TypeDesc::UINT8), TypeDesc(TypeDesc::UINT16), TypeDesc(TypeDesc::FLOAT)})
      all.push_back({std::string(packing) + ".tif", written("a.tif", type, {{"compression", packing}})});
  all.push_back({"tiled.tif", written("a.tif", TypeDesc::UINT8, {{"tile", ""}})});
  all.push_back(
      {"planes.tif", written("a.tif", TypeDesc::UINT8, {{"planarconfig", "separate"}, {"compression", "lzw"}})});
  all.push_back({"8.png", written("a.png", TypeDesc::UINT8, {})});
  all.push_back({"16.png", written("a.png", TypeDesc::UINT16, {})});
  for (const char* packing : {"none", "rle", "zips", "zip", "piz", "pxr24", "dwaa", "dwab"})
    all.push_back({std::string(packing) + ".exr", written("a.exr", TypeDesc::HALF, {{"compression", packing}})});
  all.push_back({"tiled.exr", written("a.exr", TypeDesc::FLOAT, {{"tile", ""}})});
  return all;
}

bool accepts(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const base::Error& e) {
    REQUIRE(e.status() == base::ExitStatus::content);
    REQUIRE(std::string(e.what()).find('\n') == std::string::npos);
    return false;
  }
}

bool isRead(const Sample& sample, const std::string& bytes) {
  image::ImageLimits limits;
  limits.negative = true;
  return accepts([&] { image::readImage(sample.name, std::as_bytes(std::span(bytes)), limits); });
}

/// Sizes of prefixes: short ones, the last ones, and some forty between.
std::vector<std::size_t> prefixes(std::size_t whole) {
  std::vector<std::size_t> sizes;
  for (std::size_t size = 0; size < whole;
       size += size < 16 || size + 12 > whole ? 1 : std::max<std::size_t>(1, whole / 40))
    sizes.push_back(size);
  for (std::size_t back = 1; back <= 12; ++back) sizes.push_back(whole - back);
  return sizes;
}

}  // namespace

TEST_CASE("CutPicture, EveryPrefixIsRefused") {
  for (const Sample& sample : samples()) {
    INFO(sample.name << " of " << sample.bytes.size() << " bytes");
    REQUIRE(isRead(sample, sample.bytes));
    for (const std::size_t size : prefixes(sample.bytes.size())) {
      INFO("cut to " << size);
      REQUIRE_FALSE(isRead(sample, sample.bytes.substr(0, size)));
    }
  }
}

TEST_CASE("CutPicture, TexturesToo") {
  std::vector<Sample> all = samples();
  all.push_back({"a.bmp", written("a.bmp", TypeDesc::UINT8, {})});
  all.push_back({"a.tga", written("a.tga", TypeDesc::UINT8, {})});
  for (const Sample& sample : all) {
    const std::string end = sample.name.substr(sample.name.size() - 4);
    if (end == ".exr" || end == ".tif") continue;
    INFO(sample.name << " of " << sample.bytes.size() << " bytes");
    const auto isTexture = [&](const std::string& bytes) {
      return accepts([&] { image::decodeImage(sample.name, std::as_bytes(std::span(bytes))); });
    };
    REQUIRE(isTexture(sample.bytes));
    for (const std::size_t size : prefixes(sample.bytes.size())) {
      if (end == ".tga" && size >= sample.bytes.size() - 600) continue;  // Targa's footer holds no texel
      INFO("cut to " << size);
      REQUIRE_FALSE(isTexture(sample.bytes.substr(0, size)));
    }
  }
}

TEST_CASE("CutPicture, TexelsThatStartElsewhereAreRefused") {
  const std::string whole = written("a.bmp", TypeDesc::UINT8, {});
  const auto isTexture = [&](std::int64_t start) {
    std::string bytes = whole;
    for (std::size_t i = 0; i < 4; ++i) bytes[10 + i] = static_cast<char>(start >> (8 * i));
    return accepts([&] { image::decodeImage("a.bmp", std::as_bytes(std::span(bytes))); });
  };
  const auto start = static_cast<std::int64_t>(whole.size()) - 3 * kWidth * kHeight;  // 3 x 48 bytes need no padding
  REQUIRE(isTexture(start));
  for (const std::int64_t bad :
       {std::int64_t{0}, std::int64_t{13}, start - 1, start + 1, std::int64_t{0x7fffffff}, std::int64_t{0xffffffff}}) {
    INFO(bad);
    REQUIRE_FALSE(isTexture(bad));
  }
}

TEST_CASE("CutPicture, AJpegOfThousandsOfScansIsRefused") {
  const std::string whole = jpeg(true);
  const std::string last = whole.substr(whole.rfind("\xff\xda"));  // its last scan, and the end
  std::string scans = whole.substr(0, whole.size() - 2);
  for (int i = 0; i < 1000; ++i) scans += last.substr(0, last.size() - 2);
  const Sample sample{"many.jpg", scans + "\xff\xd9"};
  REQUIRE_FALSE(isRead(sample, sample.bytes));
}

TEST_CASE("CutPicture, DamagedBytesGiveNoUnwrittenTexels") {
  // Bytes within the packed texels are changed. The picture is refused, or two reads agree.
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    for (std::size_t at = sample.bytes.size() / 4; at < sample.bytes.size(); at += sample.bytes.size() / 12) {
      std::string bytes = sample.bytes;
      bytes[at] = static_cast<char>(~bytes[at]);
      image::ImageLimits limits;
      limits.negative = true;
      image::Image first, second;
      const auto read = [&](image::Image& to) {
        return accepts([&] { to = image::readImage(sample.name, std::as_bytes(std::span(bytes)), limits); });
      };
      if (!read(first)) continue;
      const std::vector<float> dirt(first.rgb.size(), 12345.0F);  // freed memory of about the same size
      REQUIRE(dirt.size() == first.rgb.size());
      REQUIRE(read(second));
      REQUIRE(first.rgb == second.rgb);
    }
  }
}

}  // namespace welkin::tests
