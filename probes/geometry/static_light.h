// SPDX-License-Identifier: Apache-2.0
// The lights that a level's files bring: point, spot and directional lights of glTF's KHR_lights_punctual. They have no
// extent, never change, and their bounced light is part of a bake.
#pragma once

#include <span>

#include "shared.h"

namespace welkin::geometry {

using f64::Number3;

struct StaticLight {
  Number3 position;             ///< metres; of no meaning for a directional light
  Number3 intensity;            ///< radiant intensity, or the directional light's normal irradiance; scene units, >= 0
  Number3 axis{0, -1, 0};       ///< unit direction in which a spot or directional light shines
  bool directional = false;     ///< parallel light from infinitely far
  double inverse_range4 = 0.0;  ///< 1 / range^4, 1/m4; 0: no range
  double cone_scale = 0.0;      ///< of coneShare; 0: no cone
  double cone_offset = 1.0;     ///< of coneShare

  friend bool operator==(const StaticLight&, const StaticLight&) = default;
};

/// The light of a StaticLight at a point, as if nothing were between.
struct LightArriving {
  Number3 irradiance{0.0};  ///< of the side of the surface that its normal is on, scene units
  Number3 direction;        ///< unit, towards the light; set where the irradiance is above 0
  double distance = 0.0;    ///< metres, infinite for a directional light; as `direction`
};

/// glTF's formulas: intensity cos / d^2, within the cone and fading out at the range. 0 at the light itself.
LightArriving arrivingAt(const StaticLight& light, const Number3& point, const Number3& normal);

/// Irradiance of open, horizontal ground by the directional ones among lights.
Number3 onOpenGround(std::span<const StaticLight> lights);

/// Sets the cone of a spot light. Angles off the axis in radians, 0 <= inner < outer <= pi / 2.
void setCone(StaticLight& light, double inner_rad, double outer_rad);

}  // namespace welkin::geometry
