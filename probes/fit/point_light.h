// SPDX-License-Identifier: Apache-2.0
// Light of a point by path tracing, under all lights that a fit looks at.
#pragma once

#include "probes/fit/fit_points.h"
#include "probes/fit/training_skies.h"
#include "probes/transfer/paths.h"
#include "sky/base/progress.h"

namespace welkin::fit {

/// Irradiance of one side of a surface, pi included.
struct PointLight {
  std::vector<Number3> sky;  ///< by training sky, direct and bounced
  std::vector<Number3> sun;  ///< bounced, by TransferSettings::light_directions of normal irradiance 1
  Number3 emitted{0.0};      ///< as in transfer::ProbeTransfer
  std::uint64_t rays = 0;
};

/// Traces points of one level. Any thread may call it.
class PointTracer {
 public:
  /// All of them must outlive the object.
  PointTracer(const geometry::Tracer& tracer, const transfer::TransferSettings& settings, const TrainingSkies& skies)
      : tracer_(tracer), settings_(settings), skies_(skies), emissive_(transfer::anyEmissive(tracer.surfaces())) {}

  /// The light that `paths` >= 1 paths find. Their random numbers depend on `index` alone. The open sky and the ground
  /// beyond the level are integrated; the paths only tell what is in the way. So light in the open has no noise.
  PointLight trace(const FitPoint& point, std::size_t index, std::uint32_t paths) const;

 private:
  const geometry::Tracer& tracer_;
  const transfer::TransferSettings& settings_;
  const TrainingSkies& skies_;
  bool emissive_;
  transfer::CircleTable circle_;
};

}  // namespace welkin::fit
