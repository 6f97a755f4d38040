// SPDX-License-Identifier: Apache-2.0
// The gloss that a surface has before its bumps are filtered: one number, or a map.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gloss/normal_map.h"

namespace welkin::gloss {

/// Variances 1/m of the specular power m, each in [1/8192, 1]: they add where lobes are averaged.
struct GlossMap {
  int width = 1;
  int height = 1;
  std::vector<float> variance;   ///< rows from the top; empty if `number` stands for all
  std::optional<double> number;  ///< the gloss of all texels, in [0, 1]
  std::vector<Warning> warnings;
};

/// Whether a text is a number to readGloss(), in its range or not.
bool isNumber(const std::string& text);

/// Reads "0.7" as a number and anything else as a path. A map's values are gloss g, m = 2^(13 g), or with `roughness`
/// glTF's roughness. Of a coloured roughness map green counts, as in glTF, and of a coloured gloss map red. Throws
/// Error(usage) for a number out of [0, 1] and Error(content) for such a texel. Warns where the file's name says the
/// opposite.
GlossMap readGloss(const std::string& text, bool roughness);

}  // namespace welkin::gloss
