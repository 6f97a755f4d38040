// SPDX-License-Identifier: Apache-2.0
// Images of a scene, decoded.
#pragma once

#include "probes/level/scene.h"

namespace welkin::probes {

/// Throws Error(content) naming the image.
Texture decodeTexture(const TextureSource& source);

/// Mean linear colour of all texels, in [0, 1]; those of a transparent image weighted by their alpha.
f64::Number3 meanColour(const Texture& texture);

/// Whether no texel has an alpha below 1.
bool isOpaque(const Texture& texture);

}  // namespace welkin::probes
