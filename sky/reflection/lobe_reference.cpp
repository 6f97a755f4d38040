// SPDX-License-Identifier: Apache-2.0
#include "sky/reflection/lobe_reference.h"

#include <algorithm>
#include <cmath>

#include "sh/quadrature.h"
#include "sky/reflection/lobe.h"

namespace welkin::reflection {
namespace {

constexpr double kReferenceEnds = 1e-9;
constexpr int kPanels = 4;  // of the angle from the axis, on each side of the angle that touches the horizon

/// Axes of the circles: `up` is the part of +y across the axis, or any direction across it at the zenith and nadir.
struct LobeFrame {
  Number3 axis, up, side;
  double up_height;  ///< y of `up`
};

Number3 crossed(const Number3& a, const Number3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

LobeFrame frameOf(const Number3& axis) {
  const Number3 beside = std::abs(axis.y) < 1.0 - 1e-12 ? Number3{0.0, 1.0, 0.0} : Number3{1.0, 0.0, 0.0};
  Number3 up = beside - axis * dot(axis, beside);
  up = up / std::sqrt(dot(up, up));
  return {axis, up, crossed(axis, up), up.y};
}

}  // namespace

Number3 lobeReference(const Radiance& radiance, double power, const Number3& axis, const LobeNodes& nodes) {
  const LobeFrame frame = frameOf(axis);
  const sh::GaussRule out = sh::gaussLegendre(nodes.out), around = sh::gaussLegendre(nodes.around);
  Number3 sum(0.0);
  double total = 0.0;
  const auto circle = [&](double angle, double weight) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    weight *= sine * lobeWeight(power, cosine);
    // y = cosine axis.y + sine cos(turn) up_height is 0 at +-turn.
    const double crossing = -cosine * axis.y, extent = sine * frame.up_height;
    const double turn = std::abs(crossing) < extent ? std::acos(crossing / extent) : det::kHalfPi;
    const double ends[5] = {-det::kPi, -turn, 0.0, turn, det::kPi};
    for (int i = 0; i < 4; ++i)
      sh::forEachNode(around, ends[i], ends[i + 1], [&](double at, double share) {
        sum +=
            radiance(axis * cosine + (frame.up * std::cos(at) + frame.side * std::sin(at)) * sine) * (weight * share);
        total += weight * share;
      });
  };
  const double end = std::acos(lobeReach(power, kReferenceEnds));
  const double touch = std::min(std::abs(std::asin(std::clamp(axis.y, -1.0, 1.0))), end);
  // x^2 (3 - 2 x) in place of the angle: where circles begin to cross the horizon, the mean bends like a square root.
  const auto range = [&](double from, double to) {
    for (int i = 0; i < kPanels; ++i)
      sh::forEachNode(out, static_cast<double>(i) / kPanels, (i + 1.0) / kPanels, [&](double x, double share) {
        circle(from + (to - from) * x * x * (3.0 - 2.0 * x), share * (to - from) * 6.0 * x * (1.0 - x));
      });
  };
  range(0.0, touch);
  range(touch, end);
  return sum / total;
}

}  // namespace welkin::reflection
