// SPDX-License-Identifier: Apache-2.0
#include "core/polar_frame.h"

#include <algorithm>
#include <cmath>

namespace welkin::core {
namespace {

using f64::Number3;

constexpr std::size_t kMostBands = 5;
constexpr std::size_t kMost = 25;  // coefficients

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
  std::array<std::array<double, kMost>, kMost> block{};
  for (const Node& node : gaussNodes())
    for (int i = 0; i < kTurns; ++i) {
      const double angle = f64::kTwoPi * i / kTurns;
      const double across = std::sqrt(1.0 - node.x * node.x);
      const Number3 d(across * std::cos(angle), across * std::sin(angle), node.x);
      const f64::ShBasis world = f64::shBasis(d);
      const f64::ShBasis polar = f64::shBasis({d.z, d.x, d.y});
      for (std::size_t l = 0; l < kMostBands; ++l)
        for (std::size_t row = l * l; row < (l + 1) * (l + 1); ++row)
          for (std::size_t column = l * l; column < (l + 1) * (l + 1); ++column)
            block[row][column] += node.weight * f64::kTwoPi / kTurns * world.v[row] * polar.v[column];
    }
  constexpr double kRounding = 1e-12;  // a factor is 0 by symmetry or at least 1/8
  std::uint8_t count = 0;
  for (std::size_t l = 0; l < kMostBands; ++l)
    for (std::size_t row = l * l; row < (l + 1) * (l + 1); ++row) {
      first_[row] = count;
      for (int m = -static_cast<int>(l); m <= static_cast<int>(l); ++m) {
        const double factor = block[row][static_cast<std::size_t>(static_cast<int>(l * (l + 1)) + m)];
        if (std::abs(factor) > kRounding && count < kMostTerms)
          term_[count++] = {factor, static_cast<std::uint8_t>(l * (l + 1) / 2 + static_cast<std::size_t>(std::abs(m))),
                            static_cast<std::uint8_t>(m + 4)};
      }
    }
  first_[kMost] = count;
}

void PolarFrame::toWorld(std::size_t bands, std::span<const Channels> polar, const Azimuth& azimuth,
                         std::span<Channels> world) const {
  std::array<double, 2 * kMostBands - 1> turn;  // index m + 4: cos(m azimuth) for m >= 0, sin(|m| azimuth) for m < 0
  double cosine = azimuth.share;
  double sine = 0.0;
  turn[4] = 1.0;
  for (std::size_t m = 1; m < bands; ++m) {
    const double before = cosine;
    cosine = before * azimuth.cosine - sine * azimuth.sine;
    sine = sine * azimuth.cosine + before * azimuth.sine;
    turn[4 + m] = cosine;
    turn[4 - m] = sine;
  }
  for (std::size_t i = 0; i < bands * bands; ++i) {
    Channels sum{};
    for (std::size_t t = first_[i]; t < first_[i + 1]; ++t) {
      const Term& term = term_[t];
      const double factor = term.factor * turn[term.turn];
      for (std::size_t c = 0; c < 4; ++c) sum[c] += factor * polar[term.polar][c];
    }
    world[i] = sum;
  }
}

}  // namespace welkin::core
