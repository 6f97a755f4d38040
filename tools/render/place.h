// SPDX-License-Identifier: Apache-2.0
// The surface at a texel of LevelView::drawPlaces().
#pragma once

#include <optional>

#include "render/camera.h"
#include "render/offscreen.h"
#include "shared.h"

namespace welkin::render {

struct Place {
  f64::Number3 position;  ///< metres
  f64::Number3 normal;    ///< unit
  f64::Number3 towards;   ///< unit, from the surface to the camera
};

class PlaceOf {
 public:
  /// `places` must outlive the object; `camera` and `position` are those of its drawing.
  PlaceOf(const FloatImage& places, const Camera& camera, const f64::Number3& position);

  /// Nothing where there is no surface.
  std::optional<Place> operator()(uint32_t x, uint32_t y) const;

 private:
  const FloatImage& places_;
  f64::Number3 position_;
  f64::Number3 across_{0.0}, down_{0.0}, forward_{0.0};
};

}  // namespace welkin::render
