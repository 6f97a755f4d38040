// SPDX-License-Identifier: Apache-2.0
// The directions of a camera's picture.
#include "render/camera.h"

#include <cmath>

#include "shared.h"

namespace welkin::render {

std::array<float, 16> inverseViewProjection(const Camera& camera, double aspect) {
  const f64::Number3 forward = f64::directionOf(camera.yaw_rad, camera.pitch_rad);
  const f64::Number3 right = f64::directionOf(camera.yaw_rad + f64::kHalfPi, 0.0);
  const f64::Number3 up = cross(right, forward);
  const double half = std::tan(0.5 * camera.fov_rad);
  const f64::Number3 columns[4] = {right * (half * aspect), up * -half, f64::Number3(0.0), forward};
  std::array<float, 16> matrix{};
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r) matrix[static_cast<std::size_t>(4 * c + r)] = static_cast<float>(columns[c][r]);
  matrix[15] = 1.0F;
  return matrix;
}

}  // namespace welkin::render
