// SPDX-License-Identifier: Apache-2.0
#include "sh/rotation.h"

#include <cmath>

#include "sh/basis.h"
#include "sh/matrix.h"
#include "sh/quadrature.h"

namespace welkin::sh {

det::Number3 apply(const Matrix3& matrix, const det::Number3& v) {
  return {dot(matrix[0], v), dot(matrix[1], v), dot(matrix[2], v)};
}

Rotation::Rotation(int bands, const Matrix3& matrix) : bands_(bands) {
  for (int l = 0; l < bands; ++l) block_.emplace_back(static_cast<std::size_t>((2 * l + 1) * (2 * l + 1)), 0.0);
  const auto count = static_cast<std::size_t>(coefficientCount(bands));
  std::vector<double> at(count);
  std::vector<double> rotated(count);
  const LatitudeRecurrence recurrence(bands);
  const int azimuths = 2 * bands;  // trapezoid: exact up to order azimuths - 1 >= 2 (bands - 1)
  const GaussRule rule = gaussLegendre(bands);
  forEachNode(rule, -1.0, 1.0, [&](double z, double weight) {
    const double c = std::sqrt(1.0 - z * z);
    for (int k = 0; k < azimuths; ++k) {
      const double phi = det::kTwoPi * (k + 0.5) / azimuths;
      const det::Number3 d(c * det::cos(phi), c * det::sin(phi), z);
      evaluateBasis(recurrence, d, at);
      evaluateBasis(recurrence, sh::apply(matrix, d), rotated);
      for (int l = 0; l < bands; ++l)
        for (int i = 0; i <= 2 * l; ++i)
          for (int j = 0; j <= 2 * l; ++j)
            block_[static_cast<std::size_t>(l)][static_cast<std::size_t>(i * (2 * l + 1) + j)] +=
                weight * det::kTwoPi / azimuths * at[static_cast<std::size_t>(l * l + i)] *
                rotated[static_cast<std::size_t>(l * l + j)];
    }
  });
}

void Rotation::apply(std::span<const double> in, std::span<double> out) const {
  for (int l = 0; l < bands_; ++l) {
    const auto first = static_cast<std::size_t>(l * l);
    const auto size = static_cast<std::size_t>(2 * l + 1);
    const auto block = asRows(block_[static_cast<std::size_t>(l)], size);
    asVector(out.subspan(first, size)).noalias() = block * asVector(in.subspan(first, size));
  }
}

Matrix3 azimuthRotation(double angle_rad) {
  // g(d) = f(R d) with R undoing the turn: azimuth a of d becomes a - angle.
  const double c = det::cos(angle_rad);
  const double s = det::sin(angle_rad);
  return {det::Number3(c, 0.0, s), det::Number3(0.0, 1.0, 0.0), det::Number3(-s, 0.0, c)};
}

}  // namespace welkin::sh
