// SPDX-License-Identifier: Apache-2.0
// Irradiance anywhere in a baked level at one time, from its probes and grids. It is the double-precision reference for
// the runtime's volume textures.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "format/cut_lookup.h"
#include "probes/sectors/sector_file.h"
#include "sky/model/sky.h"

namespace welkin::sectors {

using f64::Number3;

/// Irradiance of one side of a surface, pi included, by source.
struct LevelIrradiance {
  Number3 sky{0.0};         ///< direct and bounced
  Number3 sun_bounce{0.0};  ///< including the moon's
  Number3 local{0.0};       ///< from emissive surfaces and the level's own lights
  Number3 total() const { return sky + sun_bounce + local; }
};

/// Sky, sun and moon at one time.
struct LightOfDay {
  std::array<Number3, 4> sky_sh{};  ///< radiance in 2 bands, upper hemisphere only
  transfer::LightAt sun, moon;
};
LightOfDay lightOfDay(const model::Sky& sky, double time_h);

/// The probes of a level, relit for one time. Immutable after construction; any thread may use it.
class LevelLight {
 public:
  /// `sectors` must belong to one level and its sky, and must outlive the object. `time_h` is finite.
  LevelLight(const std::vector<SectorFile>& sectors, const model::Sky& sky, double time_h,
             const transfer::RelightScale& scale = {}, transfer::SkyBounce sky_bounce = transfer::SkyBounce::projected);

  /// The same under any light.
  LevelLight(const std::vector<SectorFile>& sectors, const LightOfDay& light, double time_h,
             const transfer::RelightScale& scale = {}, transfer::SkyBounce sky_bounce = transfer::SkyBounce::projected);

  /// Irradiance at a position on a surface with a unit normal. It interpolates trilinearly between the eight cells
  /// around the point `push_m` >= 0 off the surface (format::pushedPlace), as far as no wall parts them from the point
  /// (format::probesAbout). Cells without a probe, or with a probe of another room than the point's, leave their weight
  /// to the others. If no cell is left, the room's own probe serves. Nothing if there is no probe at all. Not below 0.
  /// In a door of a room the point beyond its face counts by its share (format::beyondDoor).
  std::optional<LevelIrradiance> at(const Number3& position, const Number3& normal, double push_m = 1.0) const;

  /// Irradiance of a surface with this normal at one probe's place, from that probe alone. The sector must be one of
  /// the constructor's.
  LevelIrradiance ofProbe(const geometry::SectorId& sector, std::size_t probe, const Number3& normal) const;
  /// The probes of one of the sectors, in its file's order.
  const std::vector<transfer::ProbeIrradiance>& probesOf(geometry::SectorId sector) const {
    return sector_.at(sector).probe;
  }

 private:
  struct Sector {
    const SectorFile* file;
    format::GridView grid;
    std::vector<transfer::ProbeIrradiance> probe;
  };
  const Sector* sectorOf(int x, int z) const;
  /// May be below 0.
  std::optional<LevelIrradiance> ofSide(const format::InWorld& place, const Number3& normal) const;

  std::map<geometry::SectorId, Sector> sector_;
};

/// The sky's radiance at one time in 2 bands: upper hemisphere only, at intensity, desaturated.
std::array<Number3, 4> skyShAt(const model::Sky& sky, double time_h);

}  // namespace welkin::sectors
