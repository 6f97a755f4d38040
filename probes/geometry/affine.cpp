// SPDX-License-Identifier: Apache-2.0
// Transforms from quaternions and Euler angles.
#include "probes/geometry/affine.h"

#include "sh/deterministic.h"

namespace welkin::geometry {

using f64::Number3;

Affine fromTrs(const Number3& translation, const double quaternion[4], const Number3& scale) {
  const double x = quaternion[0];
  const double y = quaternion[1];
  const double z = quaternion[2];
  const double w = quaternion[3];
  return {Number3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)) * scale.x,
          Number3(2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)) * scale.y,
          Number3(2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)) * scale.z, translation};
}

Affine fromEuler(const Number3& translation, const Number3& rotation_rad, const Number3& scale) {
  const double angles[3] = {rotation_rad.x, rotation_rad.y, rotation_rad.z};
  Affine result = {Number3(scale.x, 0.0, 0.0), Number3(0.0, scale.y, 0.0), Number3(0.0, 0.0, scale.z), Number3(0.0)};
  for (int axis = 0; axis < 3; ++axis) {
    double quaternion[4] = {0.0, 0.0, 0.0, det::cos(0.5 * angles[axis])};
    quaternion[axis] = det::sin(0.5 * angles[axis]);
    result = fromTrs(Number3(0.0), quaternion, Number3(1.0)) * result;
  }
  result.translation = translation;
  return result;
}

}  // namespace welkin::geometry
