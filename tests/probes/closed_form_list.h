// SPDX-License-Identifier: Apache-2.0
// Every closed form of docs/closed_forms.md, for the test and the page that compare the path tracer, the transfer and
// what four directions make of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "probes/reference/reference.h"
#include "probes/transfer/relight.h"

namespace welkin::tests {

using f64::Number3;

/// Irradiance over pi of a normal.
using IrradianceOf = std::function<Number3(const Number3& normal)>;

struct AskedNormal {
  std::string name;
  Number3 normal;
};

struct ClosedForm {
  std::string name;
  geometry::Surfaces surfaces;
  model::Sky sky;  ///< without change over the day
  std::vector<reference::LocalLight> lamp = {};
  Number3 position;
  int bounces = 2;
  transfer::SunTransfer sun = transfer::SunTransfer::directional;
  /// For `bounces`, of the bands' own sum or of their fit.
  transfer::SkyBounce sky_bounce = transfer::SkyBounce::projected;
  IrradianceOf exact;
  /// What transfer gives a direction of the transfer basis: `exact` less what the talk's way of holding the light
  /// loses, in closed form as well. None: `exact` itself.
  IrradianceOf held = {};
  double level_bound = 0.0;  ///< how far the level itself may be off, relative to the largest `exact`
  std::vector<AskedNormal> asked = {{"up", {0, 1, 0}}};
  std::vector<std::size_t> shown = {0, 3};  ///< directions of the basis that differ: what the page has
};

std::vector<ClosedForm> closedForms();

}  // namespace welkin::tests
