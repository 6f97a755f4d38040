// SPDX-License-Identifier: Apache-2.0
// Irradiance anywhere in a baked level at one time, from its probes and grids: the reference, in double, of what the
// runtime's volume textures give.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "probes/sectors/sector_file.h"
#include "sky/model/sky.h"

namespace welkin::sectors {

using f64::Number3;

/// Irradiance of one side of a surface, pi included, by components.
struct LevelIrradiance {
  Number3 sky{0.0};         ///< direct and bounced
  Number3 sun_bounce{0.0};  ///< and the moon's
  Number3 local{0.0};       ///< of emissive surfaces
  Number3 total() const { return sky + sun_bounce + local; }
};

/// The probes of a level, relit for a time. Immutable after construction; any thread may ask.
class LevelLight {
 public:
  /// `sectors`, which outlive it, are of one level and its sky; time in hours, finite.
  LevelLight(const std::vector<SectorFile>& sectors, const model::Sky& sky, double time_h,
             const transfer::RelightScale& scale = {}, transfer::SkyBounce sky_bounce = transfer::SkyBounce::projected);

  /// At a position on a surface with a unit normal: of the eight cells about the point `push_m` off the surface, each
  /// by the probe that it names, trilinear; cells without a probe leave their weight to the others. Nothing where none
  /// has one. Cells whose probe is in another room than the point count as without; where none is left, the room's own
  /// probe serves. Not below 0.
  std::optional<LevelIrradiance> at(const Number3& position, const Number3& normal, double push_m = 1.0) const;

  /// By one probe alone, of a sector that is there: what a surface with this normal at its place gets.
  LevelIrradiance ofProbe(const geometry::SectorId& sector, std::size_t probe, const Number3& normal) const;
  /// The probes of one of the sectors, in its file's order.
  const std::vector<transfer::ProbeIrradiance>& probesOf(geometry::SectorId sector) const {
    return sector_.at(sector).probe;
  }

 private:
  struct Sector {
    const SectorFile* file;
    std::vector<transfer::ProbeIrradiance> probe;
  };
  /// The probe of the cell with these indices from the level's origin, if it is in `room`; none where there is none.
  const transfer::ProbeIrradiance* probeAt(int x, double y, int z, const geometry::Room* room) const;

  std::map<geometry::SectorId, Sector> sector_;
};

/// 2 bands of the sky's radiance at an instant: upper hemisphere only, at intensity, desaturated.
std::array<Number3, 4> skyShAt(const model::Sky& sky, double time_h);

}  // namespace welkin::sectors
