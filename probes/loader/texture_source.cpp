// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/texture_source.h"

#include <array>

#include "sh/deterministic.h"
#include "sky/image/coded_image.h"

namespace welkin::loader {

geometry::Texture decodeTexture(const level::TextureSource& source) {
  image::CodedImage image = image::decodeImage(source.name, source.bytes);
  return {image.width, image.height, std::move(image.rgba), source.wrap_u, source.wrap_v};
}

f64::Number3 meanColour(const geometry::Texture& texture) {
  // Counts codes instead of adding light, so that sums are exact in any order.
  std::array<std::array<std::uint64_t, 256>, 3> weight{};
  std::uint64_t total = 0;
  for (std::size_t i = 0; i + 3 < texture.rgba.size(); i += 4) {
    const std::uint64_t alpha = texture.rgba[i + 3];
    total += alpha;
    for (std::size_t c = 0; c < 3; ++c) weight[c][texture.rgba[i + c]] += alpha;
  }
  f64::Number3 mean(0.0);
  if (total == 0) return mean;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (std::size_t code = 0; code < 256; ++code)
      sum += static_cast<double>(weight[c][code]) * det::srgbDecode(static_cast<double>(code) / 255.0);
    mean[static_cast<int>(c)] = sum / static_cast<double>(total);
  }
  return mean;
}

namespace {

/// Mean of a channel as it stands, over 255.
double meanOf(const geometry::Texture& texture, std::size_t channel) {
  std::uint64_t sum = 0;
  for (std::size_t i = channel; i < texture.rgba.size(); i += 4) sum += texture.rgba[i];
  const auto texels = static_cast<double>(texture.rgba.size() / 4);
  return texels > 0.0 ? static_cast<double>(sum) / (255.0 * texels) : 0.0;
}

}  // namespace

double meanChannel(const geometry::Texture& texture, std::size_t channel) {
  return meanOf(texture, channel);
}

double meanAlpha(const geometry::Texture& texture) {
  return meanOf(texture, 3);
}

bool isOpaque(const geometry::Texture& texture) {
  for (std::size_t i = 3; i < texture.rgba.size(); i += 4)
    if (texture.rgba[i] != 255) return false;
  return true;
}

}  // namespace welkin::loader
