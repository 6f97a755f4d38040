// SPDX-License-Identifier: Apache-2.0
#include "render/place.h"

#include <cmath>

namespace welkin::render {

PlaceOf::PlaceOf(const FloatImage& places, const Camera& camera, const f64::Number3& position)
    : places_(places), position_(position) {
  const auto rays = inverseViewProjection(camera, static_cast<double>(places.width) / places.height);
  const auto column = [&](std::size_t c) {
    return f64::Number3(double{rays[4 * c]}, double{rays[4 * c + 1]}, double{rays[4 * c + 2]});
  };
  across_ = column(0);
  down_ = column(1);
  forward_ = column(3);
}

std::optional<Place> PlaceOf::operator()(uint32_t x, uint32_t y) const {
  const float* place = places_.pixel(x, y);
  if (!(place[3] > 0.0F)) return std::nullopt;
  const f64::Number3 ray =
      across_ * (2.0 * (x + 0.5) / places_.width - 1.0) + down_ * (2.0 * (y + 0.5) / places_.height - 1.0) + forward_;
  const f64::Number3 normal(double{place[0]}, double{place[1]}, double{place[2]});
  return Place{position_ + ray * double{place[3]}, normal / std::sqrt(dot(normal, normal)),
               -ray / std::sqrt(dot(ray, ray))};
}

}  // namespace welkin::render
