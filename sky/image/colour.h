// SPDX-License-Identifier: Apache-2.0
// Colours of other primaries as linear Rec. 709 (SMPTE RP 177, 1993), adapted to its white by Bradford's method (Lam
// 1985; CIE 15:2004 lists the matrix in its appendix on CIECAM97s).
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sh/deterministic.h"
#include "sky/image/image.h"

namespace welkin::image {

/// CIE x and y of the primaries and of the white.
struct Chromaticities {
  std::array<double, 2> red, green, blue, white;
};
inline constexpr Chromaticities kRec709{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
/// CIE XYZ as a colour space, with the equal-energy white.
inline constexpr Chromaticities kXyz{{1.0, 0.0}, {0.0, 1.0}, {0.0, 0.0}, {1.0 / 3.0, 1.0 / 3.0}};

/// A 3 x 3 matrix by its columns.
struct ColourMatrix {
  std::array<det::Number3, 3> column;

  det::Number3 operator*(const det::Number3& v) const;
  ColourMatrix operator*(const ColourMatrix& m) const;
};

/// Whether every coordinate is within 1e-4 of Rec. 709's, which is the last digit of the standard.
bool isRec709(const Chromaticities& colours);

/// XYZ of linear RGB whose white has luminance 1. None for primaries on a line, a white without luminance, or a matrix
/// with an element above 1000.
std::optional<ColourMatrix> toXyz(const Chromaticities& colours);

/// Linear Rec. 709 of XYZ under a white of the given chromaticity, whose y > 0.
ColourMatrix rec709OfXyz(const std::array<double, 2>& white);

/// Linear Rec. 709 of linear RGB. None where toXyz() has none.
std::optional<ColourMatrix> toRec709(const Chromaticities& colours);

/// The chromaticities as text for messages.
std::string textOf(const Chromaticities& colours);

/// Multiplies every texel, and adds a note that says so and names `of`. Sets the image's `converted`.
void convertColours(const ColourMatrix& matrix, const std::string& of, Image& image);

/// Converts the colours to Rec. 709 unless they are. Throws Error(content), naming `file`, for impossible ones.
void convertColours(const std::string& file, const Chromaticities& colours, Image& image);

}  // namespace welkin::image
