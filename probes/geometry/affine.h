// SPDX-License-Identifier: Apache-2.0
// Affine transforms of a level's nodes, in double: columns x, y, z and the translation.
#pragma once

#include "shared.h"

namespace welkin::geometry {

struct Affine {
  f64::Number3 x{1.0, 0.0, 0.0};
  f64::Number3 y{0.0, 1.0, 0.0};
  f64::Number3 z{0.0, 0.0, 1.0};
  f64::Number3 translation{};

  f64::Number3 linear(const f64::Number3& v) const { return x * v.x + y * v.y + z * v.z; }
  f64::Number3 point(const f64::Number3& p) const { return linear(p) + translation; }
  /// Negative for a transform that mirrors.
  double determinant() const { return dot(cross(x, y), z); }
};

/// Applies `b` first, then `a`.
inline Affine operator*(const Affine& a, const Affine& b) {
  return {a.linear(b.x), a.linear(b.y), a.linear(b.z), a.point(b.translation)};
}

/// Scales, then rotates, then translates; the rotation is the unit quaternion (x, y, z, w) of glTF.
Affine fromTrs(const f64::Number3& translation, const double quaternion[4], const f64::Number3& scale);

/// As fromTrs, but the rotation turns about x, then y, then z of the world, in radians (level.toml's XYZ Euler).
Affine fromEuler(const f64::Number3& translation, const f64::Number3& rotation_rad, const f64::Number3& scale);

}  // namespace welkin::geometry
