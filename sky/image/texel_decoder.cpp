// SPDX-License-Identifier: Apache-2.0
#include "sky/image/texel_decoder.h"

#include <fmt/format.h>
#include <webp/decode.h>

#include <cstring>

#include "sky/base/error.h"
#include "sky/image/coded_texels.h"
#include "sky/image/jpeg_read.h"
#include "sky/image/png_read.h"

namespace welkin::image {
namespace {

[[noreturn]] void refuseWebp(const std::string& name, const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
}

CodedImage decodeWebp(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(first, bytes.size(), &features) != VP8_STATUS_OK) refuseWebp(name, "damaged or cut WebP");
  if (features.has_animation != 0) refuseWebp(name, "an animation; a texture is one picture");
  CodedImage image = codedImage(name, features.width, features.height, limits);
  if (WebPDecodeRGBAInto(first, bytes.size(), image.rgba.data(), image.rgba.size(), kCodedChannels * image.width) ==
      nullptr)
    refuseWebp(name, "damaged or cut WebP");
  return image;
}

/// Puts the channels of every texel into RGBA.
void copyChannels(std::span<const std::uint8_t> code, int channels, CodedImage& image) {
  const auto n = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < code.size(); ++i) image.rgba[i / n * kCodedChannels + i % n] = code[i];
  spreadChannels(channels, image);
}

CodedImage decodeJpegTexels(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const JpegPicture jpeg = decodeJpeg(name, bytes, limits);
  CodedImage image = codedImage(name, jpeg.width, jpeg.height, limits);
  copyChannels(jpeg.code, jpeg.channels, image);
  return image;
}

CodedImage decodePngTexels(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const PngPicture png = decodePng(name, bytes, limits);
  CodedImage image = codedImage(name, png.width, png.height, limits);
  std::vector<std::uint8_t> code = png.code;
  if (png.bits == 16) {
    code.resize(png.code.size() / 2);
    for (std::size_t i = 0; i < code.size(); ++i) {
      std::uint16_t wide = 0;
      std::memcpy(&wide, png.code.data() + 2 * i, 2);
      code[i] = static_cast<std::uint8_t>((wide * 255U + 32767U) / 65535U);
    }
  }
  copyChannels(code, png.channels, image);
  return image;
}

}  // namespace

CodedImage decodeTexels(const std::string& name, std::string_view format, std::span<const std::byte> bytes,
                        const ImageLimits& limits) {
  if (format == "webp") return decodeWebp(name, bytes, limits);
  if (format == "jpeg") return decodeJpegTexels(name, bytes, limits);
  return decodePngTexels(name, bytes, limits);
}

}  // namespace welkin::image
