// SPDX-License-Identifier: Apache-2.0
// Reads Radiance pictures (G. Ward, "Real Pixels", Graphics Gems II, 1991; Radiance's "filefmts" gives the header).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sky/image/image.h"

namespace welkin::image {

/// readImage()'s part for Radiance pictures; it throws the same errors. The values are radiance: those of the file,
/// each in the middle of its step as Radiance has it, divided by the products of all EXPOSURE and of all COLORCORR.
/// PRIMARIES and XYZE become Rec. 709; XYZE names no white and is not adapted. All eight orders of the texels are
/// turned upright. A GAMMA other than 1, and a FORMAT other than RGBE and XYZE, are refused.
Image readRadiance(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits);

}  // namespace welkin::image
