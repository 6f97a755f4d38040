// SPDX-License-Identifier: Apache-2.0
#include "sky/image/coded_picture.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <utility>

#include "sky/base/error.h"
#include "sky/image/jpeg_read.h"
#include "sky/image/pixel_aspect.h"
#include "sky/image/png_read.h"

namespace welkin::image {
namespace {

/// RGB floats of codes of `channels` channels, of which one or two are grey.
template <typename Code>
std::vector<float> floatsOf(std::span<const Code> code, std::size_t channels, float largest) {
  std::vector<float> rgb;
  rgb.reserve(code.size() / channels * 3);
  for (std::size_t i = 0; i < code.size(); i += channels)
    for (std::size_t c = 0; c < 3; ++c) rgb.push_back(static_cast<float>(code[i + (channels < 3 ? 0 : c)]) / largest);
  return rgb;
}

StoredPicture pictureOf(int width, int height, std::vector<float> rgb) {
  StoredPicture picture;
  picture.image.width = width;
  picture.image.height = height;
  picture.image.rgb = std::move(rgb);
  return picture;
}

StoredPicture readJpeg(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const JpegPicture jpeg = decodeJpeg(name, bytes, limits);
  const auto channels = static_cast<std::size_t>(jpeg.channels);
  StoredPicture picture = pictureOf(jpeg.width, jpeg.height, floatsOf(std::span(jpeg.code), channels, 255.0F));
  picture.icc = jpeg.icc;
  picture.exif = jpeg.exif;
  notePixelAspect("the densities of JFIF", jpeg.pixel_aspect, picture.image);
  return picture;
}

/// The chunk cICP: primaries, transfer function, matrix and range by the numbers of ITU-T H.273.
void applyCicp(const std::string& name, const std::array<std::uint8_t, 4>& cicp, StoredPicture& picture) {
  constexpr Chromaticities kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
  constexpr Chromaticities kP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
  const auto [primaries, transfer, matrix, full] = cicp;
  const bool known = (primaries == 1 || primaries == 9 || primaries == 12) && (transfer == 8 || transfer == 13);
  if (!known || matrix != 0 || full != 1)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: the chunk cICP is {} {} {} {}; primaries 1, 9 and 12 with transfer 8 and 13 are "
                                  "read, matrix 0, range 1",
                                  name, primaries, transfer, matrix, full));
  picture.icc.clear();
  picture.gamma = transfer == 8 ? 1.0 : 0.0;
  picture.colours = primaries == 1 ? kRec709 : primaries == 9 ? kRec2020 : kP3;
}

StoredPicture readPng(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const PngPicture png = decodePng(name, bytes, limits);
  const auto channels = static_cast<std::size_t>(png.channels);
  std::vector<float> rgb;
  if (png.bits == 16) {
    std::vector<std::uint16_t> code(png.code.size() / 2);
    std::memcpy(code.data(), png.code.data(), png.code.size());
    rgb = floatsOf(std::span<const std::uint16_t>(code), channels, 65535.0F);
  } else {
    rgb = floatsOf(std::span(png.code), channels, 255.0F);
  }
  StoredPicture picture = pictureOf(png.width, png.height, std::move(rgb));
  picture.gamma = png.gamma;
  picture.colours = png.colours;
  picture.icc = png.icc;
  picture.exif = png.exif;
  picture.image.notes = png.notes;
  notePixelAspect("the chunk pHYs", png.pixel_aspect, picture.image);
  if (png.cicp) applyCicp(name, *png.cicp, picture);
  return picture;
}

}  // namespace

StoredPicture readCodedPicture(const std::string& name, std::string_view format, std::span<const std::byte> bytes,
                               const ImageLimits& limits) {
  return format == "jpeg" ? readJpeg(name, bytes, limits) : readPng(name, bytes, limits);
}

}  // namespace welkin::image
