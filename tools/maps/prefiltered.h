// SPDX-License-Identifier: Apache-2.0
// Prefiltered maps of a baked sky: mip k of n shows it as a surface of gloss 1 - k/(n - 1) reflects it.
#pragma once

#include <welkin/welkin.h>

#include <string>
#include <vector>

#include "maps/orientation.h"
#include "maps/sky_map.h"

namespace welkin::maps {

/// Largest face of a prefiltered chain, texels along an edge. The sharpest lobe is 1.3 degrees wide, which is seven
/// texels of such a face.
inline constexpr int kLargestPrefiltered = 512;

/// One map of the chain.
struct PrefilteredMip {
  Map map;
  double gloss = 1.0;  ///< in [0, 1]
  double power = 1.0;  ///< 2^(13 gloss)
  double error = 0.0;  ///< largest error at some axes, over the largest component there or of the sphere's mean
};

enum class Projection {
  cube,    ///< N x N faces, stacked downwards
  latlong  ///< 4 N x 2 N texels
};

/// All mips of N = size in [2, kLargestPrefiltered] down to 1. Every texel is the mean of welkin_dome_radiance over the
/// lobe about its centre (sky/reflection/prefilter.h). `sample` comes from the same sky. Parallel over rows; the bytes
/// do not depend on the number of threads. Errors are against sky/reflection/lobe_reference.h.
std::vector<PrefilteredMip> prefilter(const WelkinSky* sky, const WelkinSkySample& sample,
                                      const Orientation& orientation, Projection projection, int size);

/// The chain in words and numbers, as JSON.
std::string prefilterJson(const std::vector<PrefilteredMip>& mips, double time_h);

}  // namespace welkin::maps
