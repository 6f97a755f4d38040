// SPDX-License-Identifier: Apache-2.0
// A cube of radiance filtered with the lobe of a rough surface: the sum of all texels of one mip, each weighted with
// its solid angle and the lobe at its centre.
#pragma once

#include <vector>

#include "sky/reflection/cube_pyramid.h"
#include "sky/reflection/lobe.h"

namespace welkin::reflection {

/// Texels along an edge of the cube that any power of the lobe in [1, 8192] is filtered from.
inline constexpr int kSourceSize = 512;

/// Immutable.
class Prefilter {
 public:
  /// The lobe of `power` in [1, 8192]. Takes the coarsest mip whose texels are at most half the lobe's width, of 128
  /// texels or more. Within a texel, light is linear in the face's coordinates, by the means of its halves, and the
  /// lobe quadratic. So the error is of fourth order, and edges of light that lie between texels, as the horizon does,
  /// add none. The lobe ends where it is below 1e-5 of its peak. The pyramid has kSourceSize texels and outlives this.
  Prefilter(const CubePyramid& pyramid, double power);

  /// Mean radiance of the lobe about a unit axis. The weights add up to 1, so a constant radiance stays what it is.
  /// May be called from many threads.
  Number3 at(const Number3& axis) const;

 private:
  struct Gathering;
  void gather(Gathering& sum, std::size_t level, int row, int column) const;
  void gatherTexels(Gathering& sum, int row, int column) const;

  const CubePyramid& pyramid_;
  std::size_t level_;                ///< the mip that is summed
  double reach_;                     ///< least cosine of light that counts
  double steps_;                     ///< table steps for a difference of the cosine of 1
  std::vector<double> near_cosine_;  ///< of each mip: least cosine of a texel's centre that may hold light
  std::vector<LobeSlopes> slopes_;   ///< of the lobe, by 1 - cosine
};

}  // namespace welkin::reflection
