// SPDX-License-Identifier: Apache-2.0
#include "vulkan/modes_map.h"

#include <algorithm>
#include <cstring>

namespace welkin::vulkan {
namespace {

constexpr uint32_t kModesOfLayer = 4;

uint32_t layersOf(const WelkinModes& modes) {
  return std::max((modes.count + kModesOfLayer - 1) / kModesOfLayer, 1U);
}

}  // namespace

Image modesImage(const WelkinModes& modes) {
  Image image;
  image.extent = {std::max(modes.columns, 1U), std::max(modes.rows, 1U)};
  image.layers = layersOf(modes);
  image.is_array = true;
  image.format = VK_FORMAT_R16G16B16A16_SFLOAT;
  image.texel_bytes = kModesOfLayer * sizeof(uint16_t);
  return image;
}

void copyModes(const WelkinModes& modes, unsigned char* to) {
  const size_t texels = modes.count > 0 ? size_t{modes.columns} * modes.rows : 1;
  for (uint32_t first = 0; first < kModesOfLayer * layersOf(modes); first += kModesOfLayer)
    for (size_t i = 0; i < texels; ++i) {
      uint16_t rgba[kModesOfLayer] = {};
      if (modes.count > first)
        std::copy_n(modes.texels + i * modes.count + first, std::min(modes.count - first, kModesOfLayer), rgba);
      std::memcpy(to, rgba, sizeof(rgba));
      to += sizeof(rgba);
    }
}

}  // namespace welkin::vulkan
