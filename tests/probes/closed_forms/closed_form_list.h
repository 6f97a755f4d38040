// SPDX-License-Identifier: Apache-2.0
// Every closed form of docs/closed_forms.md, for the test and the page that compare path tracer, transfer and
// reconstruction from four directions.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "probes/reference/reference.h"
#include "probes/transfer/relight.h"

namespace welkin::tests {

using f64::Number3;

/// Irradiance over pi for a normal.
using IrradianceOf = std::function<Number3(const Number3& normal)>;

struct AskedNormal {
  std::string name;
  Number3 normal;
};

struct ClosedForm {
  std::string name;
  geometry::Surfaces surfaces;
  model::Sky sky;  ///< constant over the day
  std::vector<reference::LocalLight> lamp = {};
  Number3 position;
  int bounces = 2;
  transfer::SunTransfer sun = transfer::SunTransfer::directional;
  /// For `bounces`: the bands' own sum or their fit.
  transfer::SkyBounce sky_bounce = transfer::SkyBounce::projected;
  IrradianceOf exact;
  /// Expected transfer for a direction of the basis, in closed form: `exact` less the loss of the talk's way of storing
  /// light. Empty: `exact` itself.
  IrradianceOf held = {};
  double level_bound = 0.0;  ///< largest error of the level itself, relative to the largest `exact`
  std::vector<AskedNormal> asked = {{"up", {0, 1, 0}}};
  std::vector<std::size_t> shown = {0, 3};  ///< directions of the basis that differ; the page shows these
};

std::vector<ClosedForm> closedForms();

}  // namespace welkin::tests
