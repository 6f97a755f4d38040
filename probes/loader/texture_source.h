// SPDX-License-Identifier: Apache-2.0
// Decodes the images of a scene.
#pragma once

#include "probes/level/scene.h"

namespace welkin::loader {

/// Decodes an image. Throws Error(content) naming the image if that fails.
geometry::Texture decodeTexture(const level::TextureSource& source);

/// Mean linear colour of all texels, in [0, 1]. Texels of a transparent image are weighted by their alpha.
f64::Number3 meanColour(const geometry::Texture& texture);

/// Mean of a channel, 0 to 2, of all texels as it stands, over 255: of textures that hold no colours.
double meanChannel(const geometry::Texture& texture, std::size_t channel);

/// That of red.
inline double meanRed(const geometry::Texture& texture) {
  return meanChannel(texture, 0);
}

/// Mean alpha of all texels, in [0, 1].
double meanAlpha(const geometry::Texture& texture);

/// Whether no texel has an alpha below 1.
bool isOpaque(const geometry::Texture& texture);

}  // namespace welkin::loader
