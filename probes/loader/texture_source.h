// SPDX-License-Identifier: Apache-2.0
// Images of a scene, decoded.
#pragma once

#include "probes/level/scene.h"

namespace welkin::loader {

/// Throws Error(content) naming the image.
geometry::Texture decodeTexture(const level::TextureSource& source);

/// Mean linear colour of all texels, in [0, 1]; those of a transparent image weighted by their alpha.
f64::Number3 meanColour(const geometry::Texture& texture);

/// Whether no texel has an alpha below 1.
bool isOpaque(const geometry::Texture& texture);

}  // namespace welkin::loader
