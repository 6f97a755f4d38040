// SPDX-License-Identifier: Apache-2.0
// Sums over the paths of a probe, and the transfer that follows from them. Directions above and below the horizon are
// normalised separately, each by the exact integral of the cosine over its half (post-stratification). So visibility is
// 1 to rounding where nothing occludes, and everything is 0 where nothing arrives. Paths come in replicates, each with
// its own random numbers; their spread gives the standard error.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "probes/transfer/transfer.h"

namespace welkin::transfer {

using f64::Number3;

/// Independent sets of paths per probe.
inline constexpr std::size_t kReplicates = 8;
/// Half a 95 % confidence interval over the standard error: the 97.5 % quantile of Student's t with kReplicates - 1
/// degrees of freedom.
inline constexpr double kStudent = 2.364624251592785;
static_assert(kReplicates == 8);

enum class Half : std::size_t { above = 0, below = 1 };

using DirectionWeights = std::array<double, kDirections>;                 ///< max(0, w . B_b)
using DirectionColours = std::array<std::array<double, 3>, kDirections>;  ///< [direction][channel]

/// Sums over the paths of one replicate whose first direction is in one half.
struct HalfSums {
  DirectionWeights weight{};
  DirectionWeights open{};  ///< weight of paths that leave the level upward at once, times the share that passes glass
  std::array<DirectionColours, 4> sky{};  ///< by coefficient
  DirectionColours plane{};               ///< throughput of paths that meet the plane beyond the level
  DirectionColours emitted{};
  std::vector<DirectionColours> light;  ///< by light direction
};

/// Adds a path's radiance to each direction's irradiance.
inline void addWeighted(DirectionColours& sum, const DirectionWeights& weight, const Number3& radiance) {
  for (std::size_t b = 0; b < kDirections; ++b) {
    sum[b][0] += weight[b] * radiance.x;
    sum[b][1] += weight[b] * radiance.y;
    sum[b][2] += weight[b] * radiance.z;
  }
}

/// [replicate][half]
using TransferSums = std::array<std::array<HalfSums, 2>, kReplicates>;

/// The transfer and its errors. `plane_albedo` and `light_direction` determine the distant light from the plane beyond
/// the level, `plane_radiance` its light under the level's own directional lights. TransferEffort::paths and rays stay
/// 0.
TracedProbe summedUp(const TransferSums& sums, const Number3& plane_albedo, const std::vector<Number3>& light_direction,
                     const Number3& plane_radiance);

}  // namespace welkin::transfer
