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

namespace welkin::transfer {

using f64::Number3;

struct TransferSettings {
  /// Paths a probe: a multiple of kReplicates, at least kLeastRays. With max_error > 0, the most that a probe may take.
  std::size_t rays = 1024;
  /// Surfaces that a path may meet, 0..kMostBounces: light that was reflected more often is not counted.
  int bounces = 2;
  /// Of the plane that is seen where a ray leaves the level downward.
  Number3 ground_albedo{0.0};
  /// Unit directions of sun and moon along their paths. Below the horizon they give nothing.
  std::vector<Number3> light_directions;
  /// How many of them each vertex tests.
  std::size_t light_rays = 8;
  /// How far a probe sees the level along x and z, >= 0; a ray that gets farther has left it. Of the probe, not of its
  /// sector: what a probe holds does not depend on where sectors end.
  double reach_m = std::numeric_limits<double>::infinity();
  /// > 0: each probe traces until its TransferEffort::error is at most that, or `rays` are spent. 0: `rays` paths each.
  double max_error = 0.0;
};

inline constexpr std::size_t kLeastRays = 64;
inline constexpr std::size_t kMostRays = std::size_t{1} << 24;
inline constexpr int kMostBounces = 16;

/// Called from any thread, at the end of a probe and every 2048 paths at least, with the rays traced since. What it
/// throws ends the tracing.
using TransferProgress = std::function<void(std::uint64_t rays)>;

/// Traces probes of one level. Any thread may call it; a probe's result depends on nothing but level, settings,
/// position, sector and index.
class TransferTracer {
 public:
  /// `tracer` outlives it. Throws Error(content) for settings outside their range.
  TransferTracer(const geometry::Tracer& tracer, TransferSettings settings);

  TracedProbe trace(const Number3& position, geometry::SectorId sector, std::size_t probe,
                    const TransferProgress& progress = {}) const;

  /// All probes of a sector, on all threads of the caller's arena, in the sector's order.
  std::vector<TracedProbe> trace(const geometry::PlacedSector& sector) const;

  const TransferSettings& settings() const { return settings_; }

 private:
  const geometry::Tracer* tracer_;
  TransferSettings settings_;
  CircleTable circle_;
  bool emissive_;
};

/// One probe alone.
ProbeTransfer traceTransfer(const geometry::Tracer& tracer, const Number3& position, const TransferSettings& settings,
                            geometry::SectorId sector, std::size_t probe);

}  // namespace welkin::transfer
