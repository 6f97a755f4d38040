// SPDX-License-Identifier: Apache-2.0
// Radiance transfer of probes by path tracing (Stefanov, "Deferred Radiance Transfer Volumes", GDC 2012; the sun along
// its own path is ours).
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"
#include "probes/transfer/path_points.h"
#include "probes/transfer/transfer.h"
#include "sky/base/progress.h"

namespace welkin::transfer {

using f64::Number3;

struct TransferSettings {
  /// Paths per probe: a multiple of kReplicates, at least kLeastRays. With max_error > 0 it is the limit for a probe.
  std::size_t rays = 1024;
  /// Largest number of surfaces that a path meets, 0..kMostBounces. Light that was reflected more often is not counted.
  int bounces = 2;
  /// Albedo of the plane that a ray meets where it leaves the level downward.
  Number3 ground_albedo{0.0};
  /// Unit directions of sun and moon along their paths. Directions below the horizon give nothing.
  std::vector<Number3> light_directions;
  /// Number of light directions that each vertex tests.
  std::size_t light_rays = 8;
  /// Distance >= 0 to which a probe sees the level and its lights along x and z; a ray that gets farther has left it.
  /// It is measured from the probe, so sector borders do not change a probe.
  double reach_m = std::numeric_limits<double>::infinity();
  /// > 0: each probe traces until its TransferEffort::error is at most this, or `rays` are spent. 0: each probe traces
  /// `rays` paths.
  double max_error = 0.0;
};

inline constexpr std::size_t kLeastRays = 64;
inline constexpr std::size_t kMostRays = std::size_t{1} << 24;
inline constexpr int kMostBounces = 16;

/// Traces probes of one level. Any thread may call it. A probe's result depends only on level, settings, position,
/// sector and index.
class TransferTracer {
 public:
  /// `tracer` must outlive the object. Throws Error(content) if a setting is out of its range.
  TransferTracer(const geometry::Tracer& tracer, TransferSettings settings);

  /// `progress` counts rays: it is told of them at the end of a probe and every 2048 paths at least.
  TracedProbe trace(const Number3& position, geometry::SectorId sector, std::size_t probe,
                    const base::Progress& progress = {}) const;

  /// Traces all probes of a sector, in its order, on all threads of the caller's arena.
  std::vector<TracedProbe> trace(const geometry::PlacedSector& sector) const;

  const TransferSettings& settings() const { return settings_; }

 private:
  const geometry::Tracer* tracer_;
  TransferSettings settings_;
  CircleTable circle_;
  bool emissive_;
};

/// Traces a single probe.
ProbeTransfer traceTransfer(const geometry::Tracer& tracer, const Number3& position, const TransferSettings& settings,
                            geometry::SectorId sector, std::size_t probe);

}  // namespace welkin::transfer
