// SPDX-License-Identifier: Apache-2.0
#include "sky/image/image_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "sky/base/error.h"
#include "sky/base/message.h"
#include "sky/image/image_header.h"
#include "sky/image/jpeg_read.h"
#include "sky/image/png_read.h"
#include "sky/image/texel_decoder.h"
#include "sky/image/tiff_check.h"

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
  picture.orientation = jpeg.orientation;
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
  picture.orientation = png.orientation;
  picture.image.notes = png.notes;
  if (png.cicp) applyCicp(name, *png.cicp, picture);
  return picture;
}

StoredPicture readTiff(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const TiffFields fields = checkTiff(name, bytes, limits);
  const auto invalid = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
  };
  OIIO::geterror();
  OIIO::attribute("limits:imagesize_MB", 4096);
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);  // Keep stored colours; do not multiply by alpha.
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  const auto input = OIIO::ImageInput::create("tiff");
  if (!input || !input->set_ioproxy(&memory))
    throw base::Error(base::ExitStatus::file,
                      fmt::format("{}: OpenImageIO lacks TIFF: {}", name, base::oneLine(OIIO::geterror())));
  OIIO::ImageSpec spec;
  if (!input->open("picture.tif", spec, wanted))
    throw invalid("not an image that can be read: " + base::oneLine(input->geterror()));
  if (spec.depth > 1) throw invalid(fmt::format("{} slices of texels; an image is flat", spec.depth));
  requireSize(name, spec.width, spec.height, limits);
  if (spec.nchannels < 1 || spec.nchannels > 16)
    throw invalid(fmt::format("{} channels; 1 to 16 are allowed", spec.nchannels));

  const auto texels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  constexpr float kUnwritten = std::numeric_limits<float>::quiet_NaN();
  StoredPicture picture = pictureOf(spec.width, spec.height, std::vector<float>(texels * 3, kUnwritten));
  std::vector<float>& rgb = picture.image.rgb;
  const bool grey = spec.nchannels < 3;
  constexpr OIIO::stride_t kTexel = 3 * sizeof(float);
  if (!input->read_image(0, 0, 0, grey ? 1 : 3, OIIO::TypeDesc::FLOAT, rgb.data(), kTexel))
    throw invalid("damaged or cut: " + base::oneLine(input->geterror()));
  for (std::size_t i = 0; grey && i < rgb.size(); i += 3) rgb[i + 1] = rgb[i + 2] = rgb[i];
  picture.gamma = spec.format.is_floating_point() ? 1.0 : 0.0;
  picture.colours = fields.colours;
  picture.orientation = fields.orientation;
  if (fields.has_more) picture.image.notes.push_back("the first picture was read; those behind it were left out");
  if (const OIIO::ParamValue* icc = spec.find_attribute("ICCProfile"); icc != nullptr) {
    const auto* first = static_cast<const std::byte*>(icc->data());
    picture.icc.assign(first, first + icc->datasize());
  }
  return picture;
}

StoredPicture read(const std::string& name, const char* format, std::span<const std::byte> bytes,
                   const ImageLimits& limits) {
  const std::string_view f = format;
  if (f == "jpeg") return readJpeg(name, bytes, limits);
  if (f == "png") return readPng(name, bytes, limits);
  return readTiff(name, bytes, limits);
}

OIIO::ImageSpec specOf(int width, int height, int bits) {
  OIIO::ImageSpec spec(width, height, 3, bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return spec;
}

std::vector<std::byte> encodePng(int width, int height, int bits, const void* rgb) {
  OIIO::Filesystem::IOVecOutput memory;
  const auto output = OIIO::ImageOutput::create("png");
  const OIIO::ImageSpec spec = specOf(width, height, bits);
  if (output == nullptr || !output->set_ioproxy(&memory) || !output->open("picture.png", spec) ||
      !output->write_image(spec.format, rgb) || !output->close())
    throw base::Error(base::ExitStatus::internal,
                      fmt::format("OpenImageIO cannot encode a PNG of {} x {}: {}", width, height,
                                  base::oneLine(output ? output->geterror() : OIIO::geterror())));
  const auto bytes = std::as_bytes(std::span(memory.buffer()));
  return {bytes.begin(), bytes.end()};
}

void drawCaption(int width, int height, std::uint8_t* rgb, const Caption& caption) {
  using OIIO::ImageBufAlgo::TextAlignX;
  using OIIO::ImageBufAlgo::TextAlignY;
  OIIO::ImageBuf buffer(specOf(width, height, 8), rgb);
  OIIO::ImageBufAlgo::render_text(buffer, caption.x, caption.y, caption.text, caption.size, caption.font,
                                  {0.8F, 0.8F, 0.8F}, TextAlignX::Center, TextAlignY::Center);
}

constexpr ImageModule kModule{read, decodeTexels, encodePng, drawCaption};

}  // namespace
}  // namespace welkin::image

extern "C" __attribute__((visibility("default"))) const welkin::image::ImageModule* welkinImageModule() {
  return &welkin::image::kModule;
}
