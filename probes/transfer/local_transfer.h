// SPDX-License-Identifier: Apache-2.0
// Local radiance transfer: what a level sends to a probe of a white point light, for lights at fixed places, those of
// probes ("virtual" lights). At run time dynamic lights are shared among these. Stefanov, "Deferred Radiance Transfer
// Volumes" (GDC 2012); Kristensen, Akenine-Moller and Jensen, "Precomputed Local Radiance Transfer for Real-Time
// Lighting Design" (2005).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"
#include "probes/transfer/path_points.h"
#include "probes/transfer/trace_transfer.h"

namespace welkin::transfer {

using f64::Number3;

inline constexpr std::size_t kMostLocalLights = 128;  ///< of a probe

struct LocalSettings {
  /// Paths a probe: a multiple of kReplicates, kLeastRays to kMostRays. With max_error > 0, the most that one may take.
  std::size_t rays = 1024;
  int bounces = 2;                        ///< surfaces that light bounces off at most, 1..kMostBounces
  std::size_t light_rays = 8;             ///< lights that each vertex of a path tests, at least 1
  std::size_t lights = kMostLocalLights;  ///< kept a probe, 1..kMostLocalLights
  /// Surfaces nearer to a virtual light than this, 0..kSector_m, are lit as if they were this far away. It stands for
  /// lamps some metres about it: exact for one in its place only at 0, but then a light beside a wall makes a spot of
  /// all of them.
  double nearest_m = 0.0;
  /// > 0, less than 1: each probe traces until its LocalProbe::error is at most that, or `rays` are spent. 0: `rays`
  /// paths each.
  double max_error = 0.0;
  /// How far a probe sees the level and its lights along x and z, as TransferSettings::reach_m.
  double reach_m = std::numeric_limits<double>::infinity();
};

/// Of a virtual light of radiant intensity 1 at a probe.
struct LocalTransfer {
  std::uint32_t light = 0;  ///< index of its position
  /// Bounced radiance at the probe, 2 bands: the integral over the sphere of radiance times Y_k, index l (l + 1) + m.
  /// The light itself is not in it.
  std::array<Number3, 4> radiance{};

  /// Its energy for choosing: the channels' sum of coefficient 0.
  double influence() const { return radiance[0].x + radiance[0].y + radiance[0].z; }
};

struct LocalProbe {
  std::vector<LocalTransfer> transfer;  ///< of lights from which some light arrived, ascending
  std::vector<Number3> standard_error;  ///< of coefficient 0 of each
  /// Half the 95 % confidence interval of every transfer's influence, summed, over the probe's influence: what a lamp
  /// in a light's place is off by, averaged by influence. All of them lit alike are off by no more. 0 where no light
  /// arrived.
  double error = 0.0;
  std::size_t paths = 0;   ///< without those of the choice
  std::uint64_t rays = 0;  ///< segments of paths and tests of lights, those of the choice included
};

/// Traces probes of one level. Any thread may call it; a probe's result depends on nothing but level, settings, list of
/// lights, position, sector and index. Rays a probe are bounded, however many lights there are: paths bounces
/// (1 + light_rays). Where there are more lights than `lights`, the choice takes an eighth of LocalSettings::rays as
/// paths of its own, at most 4096 and under a budget 128, and one ray for each light more.
class LocalTransferTracer {
 public:
  /// `tracer` outlives it; `lights`: positions of virtual lights, near the sector. Throws Error(content) for settings
  /// outside their range and positions that are not finite.
  LocalTransferTracer(const geometry::Tracer& tracer, const LocalSettings& settings, std::vector<Number3> lights);

  LocalProbe trace(const Number3& position, geometry::SectorId sector, std::size_t probe,
                   const TransferProgress& progress = {}) const;

  /// All probes of a sector, on all threads of the caller's arena, in the sector's order.
  std::vector<LocalProbe> trace(const geometry::PlacedSector& sector) const;

  const std::vector<Number3>& lights() const { return light_; }

 private:
  const geometry::Tracer* tracer_;
  LocalSettings settings_;
  std::vector<Number3> light_;
  CircleTable circle_;
};

}  // namespace welkin::transfer
