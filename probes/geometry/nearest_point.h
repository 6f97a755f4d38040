// SPDX-License-Identifier: Apache-2.0
// The point of a triangle nearest to another point. Ericson, "Real-Time Collision Detection" (2005), 5.1.5.
#pragma once

#include <algorithm>

#include "shared.h"

namespace welkin::geometry {

/// The point of the triangle a, b, c nearest to p. A triangle without area gives a point of one of its edges.
inline f64::Number3 nearestPoint(const f64::Number3& p, const f64::Number3& a, const f64::Number3& b,
                                 const f64::Number3& c) {
  const f64::Number3 ab = b - a;
  const f64::Number3 ac = c - a;
  const double a_b = dot(ab, p - a);
  const double a_c = dot(ac, p - a);
  if (a_b <= 0.0 && a_c <= 0.0) return a;
  const double b_b = dot(ab, p - b);
  const double b_c = dot(ac, p - b);
  if (b_b >= 0.0 && b_c <= b_b) return b;
  const double c_b = dot(ab, p - c);
  const double c_c = dot(ac, p - c);
  if (c_c >= 0.0 && c_b <= c_c) return c;
  const auto along = [](const f64::Number3& from, const f64::Number3& way, double part, double whole) {
    return from + way * (whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0);
  };
  const double of_c = a_b * b_c - b_b * a_c;
  if (of_c <= 0.0 && a_b >= 0.0 && b_b <= 0.0) return along(a, ab, a_b, a_b - b_b);
  const double of_b = c_b * a_c - a_b * c_c;
  if (of_b <= 0.0 && a_c >= 0.0 && c_c <= 0.0) return along(a, ac, a_c, a_c - c_c);
  const double of_a = b_b * c_c - c_b * b_c;
  if (of_a <= 0.0 && b_c >= b_b && c_b >= c_c) return along(b, c - b, b_c - b_b, (b_c - b_b) + (c_b - c_c));
  const double all = of_a + of_b + of_c;
  return a + ab * (of_b / all) + ac * (of_c / all);
}

}  // namespace welkin::geometry
