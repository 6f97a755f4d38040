// SPDX-License-Identifier: Apache-2.0
#include "sky/image/image_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>

#include "sh/deterministic.h"
#include "sky/base/error.h"
#include "sky/image/image_header.h"
#include "sky/image/texel_decoder.h"

namespace welkin::image {
namespace {

/// Exponent of the decoding. 0 means sRGB's own curve, 1 means linear.
double decodingGamma(const OIIO::ImageSpec& spec) {
  const std::string space = spec.get_string_attribute("oiio:ColorSpace");
  if (spec.format.is_floating_point() || space == "Linear" || space == "linear") return 1.0;
  const double gamma = double{spec.get_float_attribute("oiio:Gamma", 0.0F)};
  const bool near_srgb = std::abs(gamma - 2.2) < 0.03;  // PNG's gAMA chunk writes sRGB this way.
  return space.starts_with("Gamma") && gamma > 0.0 && !near_srgb ? gamma : 0.0;
}

Image read(const std::filesystem::path& path, const char* format, const ImageLimits& limits) {
  const std::string name = path.string();
  const auto invalid = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
  };
  OIIO::geterror();
  OIIO::attribute("limits:imagesize_MB", 4096);
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);  // Keep stored colours; do not multiply by alpha.
  const auto input = OIIO::ImageInput::create(format);
  if (!input)
    throw base::Error(base::ExitStatus::file,
                      fmt::format("{}: OpenImageIO lacks {}: {}", name, format, OIIO::geterror()));
  OIIO::ImageSpec spec;
  if (!input->open(name, spec, wanted)) throw invalid("not an image that can be read: " + input->geterror());
  if (spec.depth > 1) throw invalid(fmt::format("{} slices of texels; an image is flat", spec.depth));
  requireSize(name, spec.width, spec.height, limits);
  if (spec.nchannels < 1 || spec.nchannels > 16)
    throw invalid(fmt::format("{} channels; 1 to 16 are allowed", spec.nchannels));

  const auto texels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  Image image{spec.width, spec.height, std::vector<float>(texels * 3), EnvironmentMap::none};
  const bool grey = spec.nchannels < 3;
  constexpr OIIO::stride_t kTexel = 3 * sizeof(float);
  if (!input->read_image(0, 0, 0, grey ? 1 : 3, OIIO::TypeDesc::FLOAT, image.rgb.data(), kTexel))
    throw invalid("damaged or cut: " + input->geterror());
  const double gamma = decodingGamma(spec);
  for (std::size_t i = 0; i < texels; ++i) {
    float* texel = image.rgb.data() + 3 * i;
    if (grey) texel[1] = texel[2] = texel[0];
    if (gamma == 1.0) continue;
    for (std::size_t c = 0; c < 3; ++c)
      texel[c] =
          static_cast<float>(gamma == 0.0 ? det::srgbDecode(double{texel[c]}) : det::pow(double{texel[c]}, gamma));
  }
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
    throw base::Error(base::ExitStatus::internal, fmt::format("OpenImageIO cannot encode a PNG of {} x {}: {}", width,
                                                              height, output ? output->geterror() : OIIO::geterror()));
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
