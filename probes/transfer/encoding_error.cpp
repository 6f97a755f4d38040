// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/encoding_error.h"

#include <algorithm>
#include <cmath>

#include "sh/deterministic.h"

namespace welkin::transfer {

using f64::Number3;
namespace {

void worsen(double& worst, double a, double b, double over = 1.0) {
  worst = std::max(worst, std::abs(a - b) / over);
}

/// The largest coefficient of any sky whose radiance is 0 to 1 above the horizon and 0 below. It is the integral of the
/// basis function over the directions where it is positive.
std::array<double, 4> largestOfSkies() {
  const double side = det::kShLinear * det::kPi / 2.0;
  return {det::kShConstant * det::kTwoPi, det::kShLinear * det::kPi, side, side};
}

std::vector<Number3> valuesAt(const SunModes& modes, std::size_t knot) {
  std::vector<Number3> value;
  for (std::size_t m = 0; m < modes.count(); ++m) value.push_back(modes.value[m * modes.knots() + knot]);
  return value;
}

void addTransfer(EncodingError& error, const ProbeTransfer& a, const ProbeTransfer& b) {
  const auto largest = largestOfSkies();
  double brightest = 0.0;
  for (const Number3& emitted : a.emitted) brightest = std::max({brightest, emitted.x, emitted.y, emitted.z});
  for (std::size_t d = 0; d < kDirections; ++d) {
    worsen(error.visibility, a.visibility[d], b.visibility[d]);
    for (int c = 0; c < 3; ++c) {
      double bound = 0.0;
      for (std::size_t k = 0; k < 4; ++k) bound += largest[k] * std::abs(a.sky[d][k][c] - b.sky[d][k][c]);
      error.sky = std::max(error.sky, bound / det::kPi);
      if (brightest > 0.0) worsen(error.emitted, a.emitted[d][c], b.emitted[d][c], brightest);
    }
  }
}

}  // namespace

EncodingError encodingError(const SectorProbes& probes, const SectorProbes& decoded) {
  EncodingError error;
  for (std::size_t i = 0; i < probes.position.size(); ++i) {
    for (int c = 0; c < 3; ++c) worsen(error.position_m, probes.position[i][c], decoded.position[i][c]);
    addTransfer(error, probes.transfer[i], decoded.transfer[i]);
  }
  for (std::size_t knot = 0; knot < probes.modes.knots(); ++knot) {
    const auto mode = valuesAt(probes.modes, knot);
    const auto decoded_mode = valuesAt(decoded.modes, knot);
    for (std::size_t i = 0; i < probes.position.size(); ++i)
      for (std::size_t d = 0; d < kDirections; ++d) {
        const Number3 a = sunTransfer(probes.sun[i][d], mode);
        const Number3 b = sunTransfer(decoded.sun[i][d], decoded_mode);
        for (int c = 0; c < 3; ++c) worsen(error.sun, a[c], b[c]);
      }
  }
  return error;
}

}  // namespace welkin::transfer
