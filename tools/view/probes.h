// SPDX-License-Identifier: Apache-2.0
// The probes of a level as spheres, shaded by a part of their light.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/probe_sphere.h"
#include "view/level.h"
#include "view/level_text.h"

namespace welkin::view {

/// The double-precision light of a level's probes at the state's time, with its factors.
sectors::LevelLight lightOfProbes(const Level& level, double time_h, const Changes& changes);

/// The share of a sky of the same radiance everywhere that reaches the probes, bounces included, as irradiance over
/// that of open ground: 1 where nothing stands in its way.
sectors::LevelLight visibilityOfProbes(const Level& level);

/// Spheres for every probe. Of the visibility, they are as bright as white ground under a sky of irradiance
/// `open_ground`.
std::vector<render::ProbeSphere> spheresOf(const Level& level, double time_h, const Changes& changes, ProbeShade shade,
                                           double open_ground);

struct ProbeNumbers {
  ProbeName name;
  f64::Number3 position;
  f64::Number3 up{0.0}, down{0.0};                     ///< irradiance of surfaces that face up and down
  f64::Number3 sky{0.0}, sun_bounce{0.0}, local{0.0};  ///< shares of `up`
  double visibility = 0.0;                             ///< of `up`, under a uniform sky
  std::size_t bytes = 0;
};
ProbeNumbers numbersOf(const Level& level, const ProbeName& name, double time_h, const Changes& changes);

/// The nearest probe whose sphere a ray meets before `far`.
std::optional<ProbeName> probeOnRay(const Level& level, const f64::Number3& origin, const f64::Number3& direction,
                                    double far);

/// The nearest probe by hand whose sphere, as large as those of probes, a ray meets before `far`.
std::optional<std::size_t> handOnRay(const HandPlaced& placed, const f64::Number3& origin,
                                     const f64::Number3& direction, double far);

}  // namespace welkin::view
