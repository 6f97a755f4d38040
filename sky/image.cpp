// SPDX-License-Identifier: Apache-2.0
#include "sky/image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "sh/deterministic.h"
#include "sky/atomic_file.h"
#include "sky/error.h"

namespace welkin::sky {
namespace {

constexpr int kLargestSide = 16384;
constexpr int kMostTexels = 1 << 24;

/// Exponent of the decoding: 0 for sRGB's own curve, 1 for linear.
double decodingGamma(const OIIO::ImageSpec& spec) {
  const std::string space = spec.get_string_attribute("oiio:ColorSpace");
  if (spec.format.is_floating_point() || space == "Linear" || space == "linear") return 1.0;
  const double gamma = double{spec.get_float_attribute("oiio:Gamma", 0.0F)};
  const bool near_srgb = std::abs(gamma - 2.2) < 0.03;  // how PNG's gAMA chunk writes sRGB
  return space.starts_with("Gamma") && gamma > 0.0 && !near_srgb ? gamma : 0.0;
}

}  // namespace

Image readImage(const std::filesystem::path& path) {
  const std::string name = path.string();
  const auto invalid = [&](const std::string& why) {
    return Error(ExitStatus::content, fmt::format("{}: {}", name, why));
  };
  readFile(path);  // a file that is not there or may not be read is the system's refusal, not the image's
  OIIO::geterror();
  OIIO::attribute("limits:imagesize_MB", 4096);
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);  // colours as they are stored, not multiplied by alpha
  const auto input = OIIO::ImageInput::open(name, &wanted);
  if (!input) throw invalid("not an image that can be read: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > kLargestSide || spec.height > kLargestSide || spec.depth > 1)
    throw invalid(fmt::format("{} x {} texels; 1 to {} a side are allowed", spec.width, spec.height, kLargestSide));
  if (spec.nchannels < 1 || spec.nchannels > 16)
    throw invalid(fmt::format("{} channels; 1 to 16 are allowed", spec.nchannels));
  const auto texels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  if (texels > kMostTexels)
    throw invalid(fmt::format("{} x {} texels; at most {} in all are allowed", spec.width, spec.height, kMostTexels));
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  const double gamma = decodingGamma(spec);
  std::vector<float> raw(texels * channels);
  const bool read = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, raw.data());
  if (!read) throw invalid("damaged or cut: " + input->geterror());

  Image image{spec.width, spec.height, std::vector<float>(texels * 3)};
  const bool grey = channels < 3;
  for (std::size_t i = 0; i < texels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double encoded = double{raw[i * channels + (grey ? 0 : c)]};
      if (!(encoded >= 0.0 && encoded <= double{std::numeric_limits<float>::max()}))
        throw invalid(fmt::format("{} at column {}, row {} from the top, channel {}; finite values from 0 are allowed",
                                  encoded, i % static_cast<std::size_t>(spec.width),
                                  i / static_cast<std::size_t>(spec.width), c));
      image.rgb[i * 3 + c] = static_cast<float>(gamma == 0.0   ? det::srgbDecode(encoded)
                                                : gamma == 1.0 ? encoded
                                                               : det::pow(encoded, gamma));
    }
  return image;
}

}  // namespace welkin::sky
