// SPDX-License-Identifier: Apache-2.0
#include "sky/image/texel_decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <webp/decode.h>

#include <cstring>
#include <string_view>

#include "sky/base/error.h"
#include "sky/base/message.h"
#include "sky/image/dds_header.h"
#include "sky/image/image_header.h"
#include "sky/image/jpeg_read.h"
#include "sky/image/png_read.h"

namespace welkin::image {
namespace {

constexpr int kChannels = 4;

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
}

CodedImage imageOf(const std::string& name, int width, int height, const ImageLimits& limits) {
  requireSize(name, width, height, limits);
  const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint8_t>(kChannels * texels, 255)};
}

CodedImage decodeWebp(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(first, bytes.size(), &features) != VP8_STATUS_OK) refuse(name, "damaged or cut WebP");
  if (features.has_animation != 0) refuse(name, "an animation; a texture is one picture");
  CodedImage image = imageOf(name, features.width, features.height, limits);
  if (WebPDecodeRGBAInto(first, bytes.size(), image.rgba.data(), image.rgba.size(), kChannels * image.width) == nullptr)
    refuse(name, "damaged or cut WebP");
  return image;
}

/// Spreads the channels to RGBA. Two channels are grey and alpha. Without alpha (one or three) it stays 255.
void spreadChannels(int channels, CodedImage& image) {
  if (channels >= 3) return;
  for (std::size_t i = 0; i < image.rgba.size(); i += kChannels) {
    std::uint8_t* texel = image.rgba.data() + i;
    if (channels == 2) texel[3] = texel[1];
    texel[1] = texel[2] = texel[0];
  }
}

/// Puts the channels of every texel into RGBA.
void copyChannels(std::span<const std::uint8_t> code, int channels, CodedImage& image) {
  const auto n = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < code.size(); ++i) image.rgba[i / n * kChannels + i % n] = code[i];
  spreadChannels(channels, image);
}

CodedImage decodeJpegTexels(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const JpegPicture jpeg = decodeJpeg(name, bytes, limits);
  CodedImage image = imageOf(name, jpeg.width, jpeg.height, limits);
  copyChannels(jpeg.code, jpeg.channels, image);
  return image;
}

CodedImage decodePngTexels(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const PngPicture png = decodePng(name, bytes, limits);
  CodedImage image = imageOf(name, png.width, png.height, limits);
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

CodedImage decodeByOiio(const std::string& name, const char* format, std::span<const std::byte> bytes,
                        const ImageLimits& limits) {
  OIIO::geterror();
  OIIO::attribute("limits:imagesize_MB", 4096);
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::create(format);
  if (!input || !input->set_ioproxy(&memory))
    throw base::Error(base::ExitStatus::file,
                      fmt::format("{}: OpenImageIO lacks {}: {}", name, format, base::oneLine(OIIO::geterror())));
  OIIO::ImageSpec spec;
  if (!input->open(std::string("texture.") + format, spec, wanted))
    refuse(name, "damaged or cut: " + base::oneLine(input->geterror()));
  if (spec.nchannels < 1 || spec.nchannels > kChannels)
    refuse(name, fmt::format("{} channels; 1 to {} are allowed", spec.nchannels, kChannels));
  CodedImage image = imageOf(name, spec.width, spec.height, limits);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.rgba.data(), kChannels))
    refuse(name, "damaged or cut: " + base::oneLine(input->geterror()));
  spreadChannels(spec.nchannels, image);
  return image;
}

}  // namespace

CodedImage decodeTexels(const std::string& name, const char* format, std::span<const std::byte> bytes,
                        const ImageLimits& limits) {
  const std::string_view f = format;
  if (f == "webp") return decodeWebp(name, bytes, limits);
  if (f == "jpeg") return decodeJpegTexels(name, bytes, limits);
  if (f == "png") return decodePngTexels(name, bytes, limits);
  if (f == "dds") {
    const DdsLevel level = ddsLevel(bytes, limits.largest_side);
    if (!level.why_unusable.empty()) refuse(name, "damaged or cut: " + level.why_unusable);
    return decodeByOiio(name, format, level.file, limits);
  }
  return decodeByOiio(name, format, bytes, limits);
}

}  // namespace welkin::image
