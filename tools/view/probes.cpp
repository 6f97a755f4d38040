// SPDX-License-Identifier: Apache-2.0
#include "view/probes.h"

#include <algorithm>
#include <cmath>

#include "render/shaders/level_constants.h"

namespace welkin::view {
namespace {

using f64::Number3;

transfer::RelightScale scaleOf(const Level& level, const Changes& changes) {
  transfer::RelightScale scale = level.subject().level->section.scale;
  scale.sky *= changes.sky;
  scale.sun_bounce *= changes.sun_bounce;
  return scale;
}

/// The part that a shade shows, by direction of the transfer basis.
std::array<Number3, transfer::kDirections> partOf(const transfer::ProbeIrradiance& probe, ProbeShade shade,
                                                  double local) {
  std::array<Number3, transfer::kDirections> part{};
  const auto all = shade == ProbeShade::irradiance;
  for (std::size_t b = 0; b < part.size(); ++b) {
    if (all || shade == ProbeShade::sky || shade == ProbeShade::visibility) part[b] += probe.sky[b];
    if (all || shade == ProbeShade::sun_bounce) part[b] += probe.sun_bounce[b];
    if (all || shade == ProbeShade::local) part[b] += probe.local[b] * local;
  }
  return part;
}

/// Whether a ray meets a probe's sphere before `far`, which is then the distance.
bool meetsSphere(const Number3& middle, const Number3& origin, const Number3& direction, double& far) {
  const Number3 to = middle - origin;
  const double along = dot(to, direction);
  const double left = WELKIN_PROBE_RADIUS * WELKIN_PROBE_RADIUS - (dot(to, to) - along * along);
  if (left < 0.0) return false;
  const double distance = along - std::sqrt(left);
  if (distance <= 0.0 || distance >= far) return false;
  far = distance;
  return true;
}

}  // namespace

sectors::LevelLight lightOfProbes(const Level& level, double time_h, const Changes& changes) {
  sectors::LightOfDay day = sectors::lightOfDay(level.subject().sky.sky, time_h);
  for (Number3& sh : day.sky_sh) sh = det::desaturate(sh, changes.saturation);
  return {level.sectors(), day, time_h, scaleOf(level, changes)};
}

sectors::LevelLight visibilityOfProbes(const Level& level) {
  // Radiance 1 / pi over the upper hemisphere in 2 bands: open ground has irradiance 1.
  sectors::LightOfDay white;
  white.sky_sh[0] = Number3(std::sqrt(f64::kPi) / f64::kPi);
  white.sky_sh[1] = Number3(std::sqrt(0.75 * f64::kPi) / f64::kPi);
  return {level.sectors(), white, 0.0};
}

std::vector<render::ProbeSphere> spheresOf(const Level& level, double time_h, const Changes& changes, ProbeShade shade,
                                           double open_ground) {
  std::vector<render::ProbeSphere> spheres;
  if (shade == ProbeShade::off) return spheres;
  const bool visibility = shade == ProbeShade::visibility;
  const sectors::LevelLight light = visibility ? visibilityOfProbes(level) : lightOfProbes(level, time_h, changes);
  const double unit = visibility ? open_ground : 1.0;
  for (const sectors::SectorFile& sector : level.sectors()) {
    const std::vector<Number3> position = transfer::decodedProbes(sector.probes, sector.id).position;
    const std::vector<transfer::ProbeIrradiance>& probes = light.probesOf(sector.id);
    for (std::size_t i = 0; i < position.size(); ++i) {
      const auto part = partOf(probes[i], shade, changes.local);
      render::ProbeSphere& sphere = spheres.emplace_back();
      for (int c = 0; c < 3; ++c) {
        sphere.position[c] = static_cast<float>(position[i][c]);
        for (std::size_t b = 0; b < part.size(); ++b) sphere.irradiance[b][c] = static_cast<float>(part[b][c] * unit);
      }
    }
  }
  return spheres;
}

ProbeNumbers numbersOf(const Level& level, const ProbeName& name, double time_h, const Changes& changes) {
  const sectors::LevelLight light = lightOfProbes(level, time_h, changes);
  const Number3 up(0.0, 1.0, 0.0), down(0.0, -1.0, 0.0);
  sectors::LevelIrradiance above = light.ofProbe(name.sector, name.number, up);
  sectors::LevelIrradiance below = light.ofProbe(name.sector, name.number, down);
  for (sectors::LevelIrradiance* e : {&above, &below}) e->local = e->local * changes.local;
  return {name,
          level.placeOf(name),
          above.total(),
          below.total(),
          above.sky,
          above.sun_bounce,
          above.local,
          f64::luminanceOf(visibilityOfProbes(level).ofProbe(name.sector, name.number, up).sky),
          level.sector(name.sector)->probes.bytesAProbe()};
}

std::optional<ProbeName> probeOnRay(const Level& level, const Number3& origin, const Number3& direction, double far) {
  std::optional<ProbeName> nearest;
  for (const sectors::SectorFile& sector : level.sectors()) {
    const std::vector<Number3> position = transfer::decodedProbes(sector.probes, sector.id).position;
    for (std::size_t i = 0; i < position.size(); ++i)
      if (meetsSphere(position[i], origin, direction, far)) nearest = {sector.id, i};
  }
  return nearest;
}

std::optional<std::size_t> handOnRay(const HandPlaced& placed, const Number3& origin, const Number3& direction,
                                     double far) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < placed.probes.size(); ++i) {
    const ProbePlace& p = placed.probes[i];
    if (meetsSphere({p[0], p[1], p[2]}, origin, direction, far)) nearest = i;
  }
  return nearest;
}

}  // namespace welkin::view
