// SPDX-License-Identifier: Apache-2.0
// Mips of normals and gloss together: what averaging takes from the normals, Toksvig's formula takes from the power.
#pragma once

#include <vector>

#include "gloss/gloss_source.h"
#include "gloss/normal_map.h"
#include "sky/base/progress.h"

namespace welkin::gloss {

/// One mip. Rows from the top.
struct Mip {
  int width = 0;
  int height = 0;
  std::vector<float> normal;  ///< unit; (0, 0, 1) where the normals cancel
  std::vector<float> gloss;   ///< g' in [0, 1], power 2^(13 g')
  double mean_gloss = 0.0;
  double mean_factor = 1.0;   ///< of m'/m, the Toksvig factor, with m the power of the filtered gloss alone
  double least_length = 1.0;  ///< of the mean of unit normals over one texel
};

/// Every mip down to one texel. Mip K has max(1, floor(size / 2^K)) texels along an axis, and each is the mean over
/// just its share of mip 0, whatever the size: no texel is left out or counts twice, and a tile stays a tile. Averages
/// are in double. Gloss is averaged as the variance 1/m, then lowered by toksvigPower() of the normals' mean length;
/// the gloss map may have a size of its own. The same bits for any number of threads.
std::vector<Mip> mipsOf(const NormalMap& normals, const GlossMap& gloss, const base::Progress& progress = {});

/// The one gloss that may stand for the mips where there is room for no map (McAuley 2012: the average Toksvig factor).
struct AverageFactor {
  double gloss = 0.0;   ///< mean of the mips' mean g', mip 0 left out; each counts the same, as it covers a doubling of
                        ///< distance
  double factor = 1.0;  ///< its power over the power of the mean gloss of mip 0
};
AverageFactor averageFactorOf(const std::vector<Mip>& mips);

}  // namespace welkin::gloss
