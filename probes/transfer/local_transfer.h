// SPDX-License-Identifier: Apache-2.0
// Local radiance transfer: the light of a white point light that a level sends to a probe. The lights stand at fixed
// places, those of probes ("virtual" lights); at run time dynamic lights are shared among them. Stefanov, "Deferred
// Radiance Transfer Volumes" (GDC 2012); Kristensen, Akenine-Moller and Jensen, "Precomputed Local Radiance Transfer
// for Real-Time Lighting Design" (2005).
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

inline constexpr std::size_t kMostLocalLights = 128;  ///< limit for one probe

struct LocalSettings {
  /// Paths per probe: a multiple of kReplicates, kLeastRays to kMostRays. With max_error > 0 it is the limit for a
  /// probe.
  std::size_t rays = 1024;
  int bounces = 2;                        ///< largest number of bounces, 1..kMostBounces
  std::size_t light_rays = 8;             ///< lights that each vertex of a path tests, at least 1
  std::size_t lights = kMostLocalLights;  ///< kept per probe, 1..kMostLocalLights
  /// Surfaces nearer to a virtual light than this, 0..kSector_m, are lit as from this distance. A virtual light stands
  /// for lamps up to some metres away. Only 0 is exact for a lamp exactly there. But with 0, a virtual light beside a
  /// wall makes a bright spot on the wall for all its lamps.
  double nearest_m = 0.0;
  /// In (0, 1): each probe traces until its LocalProbe::error is at most this, or `rays` are spent. 0: each probe
  /// traces `rays` paths.
  double max_error = 0.0;
  /// Distance to which a probe sees the level and its lights along x and z, as TransferSettings::reach_m.
  double reach_m = std::numeric_limits<double>::infinity();
};

/// Transfer from a virtual light of radiant intensity 1 to a probe.
struct LocalTransfer {
  std::uint32_t light = 0;  ///< index of its position
  /// Bounced radiance at the probe, 2 bands: the integral over the sphere of radiance times Y_k, index l (l + 1) + m.
  /// Direct light is not included.
  std::array<Number3, 4> radiance{};

  /// Energy by which lights are chosen: the sum over channels of coefficient 0.
  double influence() const { return radiance[0].x + radiance[0].y + radiance[0].z; }
};

struct LocalProbe {
  std::vector<LocalTransfer> transfer;  ///< from lights of which some light arrived, ascending by light
  std::vector<Number3> standard_error;  ///< of each transfer's coefficient 0
  /// Sum over transfers of half the 95 % confidence interval of their influence, over the probe's influence. It is the
  /// error of a lamp in a light's place, averaged by influence. The error of all lights lit alike is no larger. 0 if no
  /// light arrived.
  double error = 0.0;
  std::size_t paths = 0;   ///< without the paths that choose lights
  std::uint64_t rays = 0;  ///< path segments and light tests, including those that choose lights
};

/// Traces probes of one level. Any thread may call it. A probe's result depends only on level, settings, list of
/// lights, position, sector and index. Rays per probe are limited to paths bounces (1 + light_rays), however many
/// lights there are. If there are more lights than `lights`, the choice traces more: an eighth of LocalSettings::rays
/// as paths of its own, at most 4096, or 128 under a budget, and one ray for each light.
class LocalTransferTracer {
 public:
  /// `tracer` must outlive the object. `lights` are positions of virtual lights near the sector. Throws Error(content)
  /// if a setting is out of its range or a position is not finite.
  LocalTransferTracer(const geometry::Tracer& tracer, const LocalSettings& settings, std::vector<Number3> lights);

  LocalProbe trace(const Number3& position, geometry::SectorId sector, std::size_t probe,
                   const base::Progress& progress = {}) const;

  /// Traces all probes of a sector, in its order, on all threads of the caller's arena.
  std::vector<LocalProbe> trace(const geometry::PlacedSector& sector) const;

  const std::vector<Number3>& lights() const { return light_; }

 private:
  const geometry::Tracer* tracer_;
  LocalSettings settings_;
  std::vector<Number3> light_;
  CircleTable circle_;
};

}  // namespace welkin::transfer
