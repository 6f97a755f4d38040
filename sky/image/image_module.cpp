// SPDX-License-Identifier: Apache-2.0
#include "sky/image/image_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <limits>
#include <string_view>

#include "sky/base/error.h"
#include "sky/base/message.h"
#include "sky/image/coded_texels.h"
#include "sky/image/dds_header.h"
#include "sky/image/image_header.h"
#include "sky/image/pixel_aspect.h"
#include "sky/image/tiff_check.h"

namespace welkin::image {
namespace {

base::Error refusal(const std::string& name, const std::string& why) {
  return base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
}

StoredPicture readTiff(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const TiffFields fields = checkTiff(name, bytes, limits);
  const auto invalid = [&](const std::string& why) { return refusal(name, why); };
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
  StoredPicture picture;
  picture.image.width = spec.width;
  picture.image.height = spec.height;
  picture.image.rgb.assign(texels * 3, kUnwritten);
  std::vector<float>& rgb = picture.image.rgb;
  const bool grey = spec.nchannels < 3;
  constexpr OIIO::stride_t kTexel = 3 * sizeof(float);
  if (!input->read_image(0, 0, 0, grey ? 1 : 3, OIIO::TypeDesc::FLOAT, rgb.data(), kTexel))
    throw invalid("damaged or cut: " + base::oneLine(input->geterror()));
  for (std::size_t i = 0; grey && i < rgb.size(); i += 3) rgb[i + 1] = rgb[i + 2] = rgb[i];
  picture.gamma = spec.format.is_floating_point() ? 1.0 : 0.0;
  picture.colours = fields.colours;
  picture.exif = fields.exif;
  notePixelAspect("XResolution and YResolution", fields.pixel_aspect, picture.image);
  if (fields.nits != 1.0)
    picture.image.notes.push_back(fmt::format("StoNits is {:.6g}; values are not multiplied by it", fields.nits));
  if (fields.has_more) picture.image.notes.push_back("the first picture was read; those behind it were left out");
  if (const OIIO::ParamValue* icc = spec.find_attribute("ICCProfile"); icc != nullptr) {
    const auto* first = static_cast<const std::byte*>(icc->data());
    picture.icc.assign(first, first + icc->datasize());
  }
  return picture;
}

CodedImage decode(const std::string& name, const char* format, std::span<const std::byte> bytes,
                  const ImageLimits& limits) {
  DdsLevel level;
  if (std::string_view(format) == "dds") {
    level = ddsLevel(bytes, limits.largest_side);
    if (!level.why_unusable.empty()) throw refusal(name, "damaged or cut: " + level.why_unusable);
    bytes = level.file;
  }
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
    throw refusal(name, "damaged or cut: " + base::oneLine(input->geterror()));
  if (spec.nchannels < 1 || spec.nchannels > kCodedChannels)
    throw refusal(name, fmt::format("{} channels; 1 to {} are allowed", spec.nchannels, kCodedChannels));
  CodedImage image = codedImage(name, spec.width, spec.height, limits);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.rgba.data(), kCodedChannels))
    throw refusal(name, "damaged or cut: " + base::oneLine(input->geterror()));
  spreadChannels(spec.nchannels, image);
  return image;
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

constexpr ImageModule kModule{readTiff, decode, encodePng, drawCaption};

}  // namespace
}  // namespace welkin::image

extern "C" __attribute__((visibility("default"))) const welkin::image::ImageModule* welkinImageModule() {
  return &welkin::image::kModule;
}
