// SPDX-License-Identifier: Apache-2.0
#include "core/polar_frame.h"

#include <algorithm>
#include <cmath>

namespace welkin::core {
namespace {

using f64::Number3;

/// Gauss-Legendre nodes and weights of degree 9: exact for products of two functions of 5 bands.
struct Node {
  double x, weight;
};
std::array<Node, 5> gaussNodes() {
  const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
  const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
  const double wide = (322.0 + 13.0 * std::sqrt(70.0)) / 900.0;
  const double narrow = (322.0 - 13.0 * std::sqrt(70.0)) / 900.0;
  return {{{-outer, narrow}, {-inner, wide}, {0.0, 128.0 / 225.0}, {inner, wide}, {outer, narrow}}};
}

}  // namespace

Azimuth::Azimuth(const Number3& direction) {
  const double length = f64::horizontalLength(direction);
  share = std::min(length / kPoleFade, 1.0);
  if (!(length > 0.0)) return;
  cosine = direction.z / length;
  sine = direction.x / length;
}

PolarFrame::PolarFrame() {
  constexpr int kTurns = 9;  // trapezoids over the azimuth: exact up to order 8
  for (const Node& node : gaussNodes())
    for (int i = 0; i < kTurns; ++i) {
      const double angle = f64::kTwoPi * i / kTurns;
      const double across = std::sqrt(1.0 - node.x * node.x);
      const Number3 d(across * std::cos(angle), across * std::sin(angle), node.x);
      const f64::ShBasis world = f64::shBasis(d);
      const f64::ShBasis polar = f64::shBasis({d.z, d.x, d.y});
      for (std::size_t l = 0; l < 5; ++l)
        for (std::size_t row = l * l; row < (l + 1) * (l + 1); ++row)
          for (std::size_t column = l * l; column < (l + 1) * (l + 1); ++column)
            block_[row][column] += node.weight * f64::kTwoPi / kTurns * world.v[row] * polar.v[column];
    }
}

void PolarFrame::toWorld(std::size_t bands, std::span<const Number3> polar, const Azimuth& azimuth,
                         std::span<Number3> world) const {
  double cosine[5] = {1.0};  // of m times the azimuth
  double sine[5] = {0.0};
  for (std::size_t m = 1; m < bands; ++m) {
    cosine[m] = cosine[m - 1] * azimuth.cosine - sine[m - 1] * azimuth.sine;
    sine[m] = sine[m - 1] * azimuth.cosine + cosine[m - 1] * azimuth.sine;
  }
  for (std::size_t l = 0; l < bands; ++l) {
    Number3 turned[9];  // by order, from -l
    for (std::size_t m = 0; m <= l; ++m) {
      const Number3 moment = polar[l * (l + 1) / 2 + m] * (m > 0 ? azimuth.share : 1.0);
      turned[l + m] = moment * cosine[m];
      if (m > 0) turned[l - m] = moment * sine[m];
    }
    for (std::size_t i = 0; i < 2 * l + 1; ++i) {
      Number3 sum(0.0);
      for (std::size_t j = 0; j < 2 * l + 1; ++j) sum += turned[j] * block_[l * l + i][l * l + j];
      world[l * l + i] = sum;
    }
  }
}

}  // namespace welkin::core
