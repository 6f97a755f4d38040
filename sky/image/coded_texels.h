// SPDX-License-Identifier: Apache-2.0
// An image of RGBA texels while a decoder fills it.
#pragma once

#include <string>

#include "sky/image/coded_image.h"
#include "sky/image/image_header.h"

namespace welkin::image {

inline constexpr int kCodedChannels = 4;

/// An image of texels of 255. Throws Error(content) if it is larger than allowed.
inline CodedImage codedImage(const std::string& name, int width, int height, const ImageLimits& limits) {
  requireSize(name, width, height, limits);
  const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<std::uint8_t>(kCodedChannels * texels, 255)};
}

/// Spreads the channels to RGBA. Two channels are grey and alpha. Without alpha (one or three) it stays 255.
inline void spreadChannels(int channels, CodedImage& image) {
  if (channels >= 3) return;
  for (std::size_t i = 0; i < image.rgba.size(); i += kCodedChannels) {
    std::uint8_t* texel = image.rgba.data() + i;
    if (channels == 2) texel[3] = texel[1];
    texel[1] = texel[2] = texel[0];
  }
}

}  // namespace welkin::image
