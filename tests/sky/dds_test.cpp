// SPDX-License-Identifier: Apache-2.0
// DDS textures: pixels of every kind that is read, computed by hand, and files that are not read, cut or damaged.
#include <catch2/catch.hpp>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sky/base/error.h"
#include "sky/image/coded_image.h"
#include "tests/dds_bytes.h"

namespace welkin::tests {
namespace {

using Codes = std::vector<std::uint8_t>;

std::span<const std::byte> spanOf(const std::string& bytes) {
  return std::as_bytes(std::span(bytes));
}

Codes texelsOf(const std::string& bytes) {
  REQUIRE(image::isTexture("a.dds", spanOf(bytes)));
  return image::decodeImage("a.dds", spanOf(bytes)).rgba;
}

void checkRefused(const std::string& bytes, const std::string& says) {
  INFO(says);
  REQUIRE(image::isTexture("a.dds", spanOf(bytes)));
  try {
    image::decodeImage("a.dds", spanOf(bytes));
    FAIL("it is read");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    CHECK_THAT(e.what(), Catch::StartsWith("a.dds: damaged or cut: ") && Catch::Contains(says));
  }
}

// A block of BC1: the two colours as 5, 6 and 5 bits, then 2 bits a texel. Red is more than blue, so codes 2 and 3 are
// thirds: 2/3 of 255 is 170. The rows are 0 1 2 3, 1 1 1 1, 2 2 2 2 and 3 3 3 3.
constexpr int kRed[4] = {255, 0, 170, 85};
constexpr int kBlock[8] = {0x00, 0xf8, 0x1f, 0x00, 0xe4, 0x55, 0xaa, 0xff};

/// The block's texels with this alpha in the first one, and 255 in the others.
Codes blockTexels(std::uint8_t first_alpha) {
  Codes rgba;
  for (int i = 0; i < 16; ++i) {
    const int code = i < 4 ? i : i / 4;
    rgba.push_back(static_cast<std::uint8_t>(kRed[code]));
    rgba.push_back(0);
    rgba.push_back(static_cast<std::uint8_t>(255 - kRed[code]));
    rgba.push_back(i == 0 ? first_alpha : 255);
  }
  return rgba;
}

std::string blocksOf(const DdsHeader& header, std::initializer_list<int> alpha) {
  std::string bytes = ddsOf(header, alpha);
  for (const int b : kBlock) bytes.push_back(static_cast<char>(b));
  return bytes;
}

// Alpha of BC2 is 4 bits a texel: 8 is 136 of 255. That of BC3: two values, then 3 bits a texel, of which 0 and 1 take
// the values.
const std::initializer_list<int> kAlpha2 = {0xf8, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};
const std::initializer_list<int> kAlpha3 = {255, 40, 0x01, 0, 0, 0, 0, 0};

}  // namespace

TEST_CASE("Dds, PlainPixelsByTheirMasksTopRowFirst") {
  const std::initializer_list<int> bytes = {3, 2, 1, 128, 6, 5, 4, 255, 9, 8, 7, 0, 12, 11, 10, 77};
  const Codes bgra = {1, 2, 3, 128, 4, 5, 6, 255, 7, 8, 9, 0, 10, 11, 12, 77};
  const Codes rgba = {3, 2, 1, 128, 6, 5, 4, 255, 9, 8, 7, 0, 12, 11, 10, 77};
  CHECK(texelsOf(ddsOf(ddsBgra(2, 2), bytes)) == bgra);
  for (const std::uint32_t format : {87U, 91U}) CHECK(texelsOf(ddsOf(ddsDxgi(2, 2, format), bytes)) == bgra);
  for (const std::uint32_t format : {28U, 29U}) CHECK(texelsOf(ddsOf(ddsDxgi(2, 2, format), bytes)) == rgba);
  const Codes opaque = {1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255, 10, 11, 12, 255};
  for (const std::uint32_t format : {88U, 93U}) CHECK(texelsOf(ddsOf(ddsDxgi(2, 2, format), bytes)) == opaque);
  DdsHeader header = ddsBgra(2, 2);
  header.flags = 0x40;  // the mask of alpha is there, the flag is not
  CHECK(texelsOf(ddsOf(header, bytes)) == opaque);
  header.bits = 24;
  CHECK(texelsOf(ddsOf(header, {3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10})) == opaque);
}

TEST_CASE("Dds, FewBitsAndGrey") {
  // 31 of 31; then 16 of 31, 33 of 63 and 1 of 31, rounded: 132, 134, 8.
  CHECK(texelsOf(ddsOf({2, 1, 0x40, "", 16, {0xf800, 0x7e0, 0x1f, 0}, 0, {}}, {0x00, 0xf8, 0x21, 0x84})) ==
        Codes{255, 0, 0, 255, 132, 134, 8, 255});
  CHECK(texelsOf(ddsOf({1, 1, 0x41, "", 16, {0xf00, 0xf0, 0xf, 0xf000}, 0, {}}, {0x34, 0x82})) ==
        Codes{34, 51, 68, 136});
  CHECK(texelsOf(ddsOf({2, 1, 0x20000, "", 8, {0xff, 0, 0, 0}, 0, {}}, {9, 200})) ==
        Codes{9, 9, 9, 255, 200, 200, 200, 255});
  CHECK(texelsOf(ddsOf({2, 1, 0x20001, "", 16, {0xff, 0, 0, 0xff00}, 0, {}}, {9, 200, 8, 100})) ==
        Codes{9, 9, 9, 200, 8, 8, 8, 100});
}

TEST_CASE("Dds, Blocks") {
  CHECK(texelsOf(blocksOf(ddsBlocks(4, 4, "DXT1"), {})) == blockTexels(255));
  CHECK(texelsOf(blocksOf(ddsBlocks(4, 4, "DXT3"), kAlpha2)) == blockTexels(136));
  CHECK(texelsOf(blocksOf(ddsBlocks(4, 4, "DXT5"), kAlpha3)) == blockTexels(40));
  for (const std::uint32_t format : {71U, 72U})
    CHECK(texelsOf(blocksOf(ddsDxgi(4, 4, format), {})) == blockTexels(255));
  for (const std::uint32_t format : {74U, 75U})
    CHECK(texelsOf(blocksOf(ddsDxgi(4, 4, format), kAlpha2)) == blockTexels(136));
  for (const std::uint32_t format : {77U, 78U})
    CHECK(texelsOf(blocksOf(ddsDxgi(4, 4, format), kAlpha3)) == blockTexels(40));
  // 3 x 1 texels of a block of 4 x 4.
  CHECK(texelsOf(blocksOf(ddsBlocks(3, 1, "DXT1"), {})) == Codes{255, 0, 0, 255, 0, 0, 255, 255, 170, 0, 85, 255});
  // Mode 5 of BC7 (bit 5), no rotation: 7 bits for each end of red, green and blue, 8 for alpha; all ends are alike, so
  // the indices do not matter. Red 127 is 255, green 0, blue 64 is 129, alpha 90.
  for (const std::uint32_t format : {98U, 99U}) {
    std::uint64_t low = 1U << 5U;
    std::uint64_t high = 0;
    unsigned at = 8;
    const auto put = [&](std::uint64_t value, unsigned bits) {
      for (unsigned i = 0; i < bits; ++i, ++at) (at < 64 ? low : high) |= (value >> i & 1U) << at % 64;
    };
    for (const std::uint64_t channel : {127U, 127U, 0U, 0U, 64U, 64U}) put(channel, 7);
    for (int i = 0; i < 2; ++i) put(90, 8);
    std::string bytes = ddsOf(ddsDxgi(1, 1, format), {});
    for (const std::uint64_t half : {low, high})
      for (unsigned shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<char>(half >> shift));
    CHECK(texelsOf(bytes) == Codes{255, 0, 129, 90});
  }
}

TEST_CASE("Dds, OtherPixelsAreNotRead") {
  const auto isRead = [](const DdsHeader& header) {
    return image::isTexture("a.dds", spanOf(blocksOf(header, {0, 0, 0, 0, 0, 0, 0, 0})));
  };
  CHECK(isRead(ddsBlocks(4, 4, "DXT5")));
  for (const std::string& letters : {std::string("DXT2"), std::string("DXT4"), std::string("ATI1"), std::string("ATI2"),
                                     std::string("BC5U"), std::string("UYVY"), std::string("q\0\0\0", 4)})
    CHECK_FALSE(isRead(ddsBlocks(4, 4, letters)));
  for (const std::uint32_t format : {2U, 10U, 24U, 61U, 80U, 83U, 95U, 96U}) CHECK_FALSE(isRead(ddsDxgi(4, 4, format)));
  for (const std::uint32_t caps2 : {0xfe00U, 0x200000U}) {
    DdsHeader header = ddsBlocks(4, 4, "DXT1");
    header.caps2 = caps2;
    CHECK_FALSE(isRead(header));
  }
  for (const auto& [word, value] : {std::pair{1, 4U}, {2, 4U}, {3, 2U}, {4, 2U}}) {  // volume, cube, array, multiplied
    DdsHeader header = ddsDxgi(4, 4, 72);
    CHECK(isRead(header));
    header.dxgi[static_cast<std::size_t>(word)] = value;
    CHECK_FALSE(isRead(header));
  }
  CHECK_FALSE(isRead({1, 1, 0x41, "", 32, {0x3ff00000, 0xffc00, 0x3ff, 0xc0000000}, 0, {}}));  // 10 bits a channel
  CHECK_FALSE(isRead({1, 1, 0x20000, "", 16, {0xffff, 0, 0, 0}, 0, {}}));
  CHECK_FALSE(isRead({1, 1, 2, "", 8, {0, 0, 0, 0xff}, 0, {}}));
  CHECK_FALSE(isRead({1, 1, 0x40, "", 16, {0xff0000, 0xff00, 0xff, 0}, 0, {}}));  // a mask past the pixel
}

TEST_CASE("Dds, CutAndDamagedFilesAreRefused") {
  for (const std::string& whole : {ddsOf(ddsBgra(2, 1), {3, 2, 1, 128, 6, 5, 4, 255}),
                                   blocksOf(ddsBlocks(4, 4, "DXT1"), {}), blocksOf(ddsDxgi(4, 4, 72), {})})
    for (std::size_t size = 4; size < whole.size(); ++size) {
      INFO(size << " of " << whole.size());
      checkRefused(whole.substr(0, size), size < 128 ? "of the 128 bytes" : "bytes");
    }
  const std::string whole = blocksOf(ddsBlocks(4, 4, "DXT1"), {});
  const auto with = [&](std::size_t word, std::uint32_t value) {
    std::string bytes = whole;
    for (std::size_t i = 0; i < 4; ++i) bytes[4 * word + i] = static_cast<char>(value >> (8 * i));
    return bytes;
  };
  checkRefused(with(1, 24), "sizes are 24 and 32");
  checkRefused(with(19, 0), "sizes are 124 and 0");
  checkRefused(with(3, 0), "4 x 0 texels");
  checkRefused(with(4, 0xffffffff), "4294967295 x 4 texels");
  checkRefused(with(4, 5), "its texels take 16 bytes; the file ends 8 bytes on");
  CHECK(texelsOf(whole + "more") == blockTexels(255));  // mip levels follow the first
}

}  // namespace welkin::tests
