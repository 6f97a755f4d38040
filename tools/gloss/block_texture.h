// SPDX-License-Identifier: Apache-2.0
// Mips in the blocks of 4 x 4 texels that a GPU reads, and what the blocks cost the normals. Compressed by stb_dxt.
// Source of the formats: Microsoft, "Texture Block Compression in Direct3D 11".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "gloss/mips.h"

namespace welkin::gloss {

/// Errors of decoded texels against the mips, over all texels of all mips.
struct BlockError {
  double y_rms = 0.0;      ///< of the normals' y, in [-1, 1]
  double angle_rms = 0.0;  ///< between normals, degrees; z is rebuilt from x and y
  double angle_most = 0.0;
  double gloss_rms = 0.0;  ///< against each texel's own gloss, also where one number stands for all
};

/// One texture: the blocks of each mip, row after row. Texels past an edge repeat the last one.
struct BlockTexture {
  std::vector<std::vector<std::byte>> levels;
  BlockError error;
};

/// BC3 as McAuley 2012 packs it: x in alpha, y in green, gloss in red, and blue black. Red shares its block's line of
/// colours with green, so a map there costs y. `one_gloss` puts one number in [0, 1] there, which costs nothing.
BlockTexture packBc3(const std::vector<Mip>& mips, std::optional<double> one_gloss);

/// BC5: x in red, y in green, each with a block of its own. The gloss error stays 0.
BlockTexture packBc5(const std::vector<Mip>& mips);

/// BC4: gloss in red. The normals' errors stay 0.
BlockTexture packBc4(const std::vector<Mip>& mips);

/// Values of the 16 texels of a BC4 block, which is also BC3's alpha and either half of BC5.
std::vector<double> decodeBc4(const std::byte* block);

/// Red and green of the 16 texels of the colours of a BC3 block, in [0, 1].
struct RedGreen {
  double red, green;
};
std::vector<RedGreen> decodeBc3Colours(const std::byte* block);

}  // namespace welkin::gloss
