// SPDX-License-Identifier: Apache-2.0
// ICC profiles of one matrix and three curves, or of one curve for grey (ICC.1:2022, 8.3.3 and 8.4.3).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sky/image/image.h"

namespace welkin::image {

/// Decodes stored values, 0 to 1, by the profile: its curves, then its matrix, whose white is D50, then Rec. 709
/// adapted to D65. A profile within 1e-3 of Rec. 709's primaries only decodes by its curves. Throws Error(content),
/// naming the file, for a damaged profile and for those of tables (A2B0 without a matrix), CMYK or other spaces.
void applyIccProfile(const std::string& name, std::span<const std::byte> profile, Image& image);

}  // namespace welkin::image
