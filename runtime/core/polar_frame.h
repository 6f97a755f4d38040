// SPDX-License-Identifier: Apache-2.0
// Turns the day's table from the frame of the sun's azimuth to the world's spherical harmonics.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared.h"

namespace welkin::core {

/// Red, green and blue, and their luminance. The luminance is linear, so it is turned with them, and desaturation need
/// not sum it again. Four doubles fill the vectors of any processor.
using Channels = std::array<double, 4>;

inline f64::Number3 colourOf(const Channels& v) {
  return {v[0], v[1], v[2]};
}

/// Horizontal length of the sun's direction below which the dependence on its azimuth fades. At the zenith and the
/// nadir the azimuth jumps, but the sky does not depend on it. Between a table's keys a small dependence can remain,
/// and it would make a step there. The length is 2 arc seconds. A key that near loses a quarter of the length times the
/// slope of the sky's own dependence, which stays within the 1e-5 of a bake.
inline constexpr double kPoleFade = 1e-5;

/// An azimuth by its unit horizontal direction: cosine is its z, sine its x.
struct Azimuth {
  double cosine = 1.0;
  double sine = 0.0;
  double share = 1.0;  ///< in [0, 1]: remaining share of the dependence on the azimuth (kPoleFade)

  Azimuth() = default;
  /// The azimuth of a direction's horizontal part. A vertical direction gives +z, with share 0.
  explicit Azimuth(const f64::Number3& direction);
};

/// Turns coefficients of m >= 0 about the pole +y into all coefficients about the pole +z of the basis. The two frames
/// differ by a permutation of the axes, so every coefficient of the world is a sum of at most three terms. 5 bands take
/// 45 products.
class PolarFrame {
 public:
  PolarFrame();

  /// `polar`: index l (l + 1) / 2 + m, of `bands` <= 5 bands; `world`: bands^2 coefficients, axes of the world.
  void toWorld(std::size_t bands, std::span<const Channels> polar, const Azimuth& azimuth,
               std::span<Channels> world) const;

 private:
  static constexpr std::size_t kMostTerms = 45;
  /// The product of factor, the cosine or sine of |m| azimuth, and the coefficient (l, |m|).
  struct Term {
    double factor;
    std::uint8_t polar, turn;  ///< indices of the coefficient and of Turns
  };
  std::array<Term, kMostTerms> term_;     ///< sorted by coefficient of the world
  std::array<std::uint8_t, 26> first_{};  ///< first term of each coefficient; the first term of the next one is the end
};

}  // namespace welkin::core
