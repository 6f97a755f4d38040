// SPDX-License-Identifier: Apache-2.0
// Turns the day's table from the frame of the sun's azimuth to the world's spherical harmonics.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "shared.h"

namespace welkin::core {

/// Red, green and blue, and their luminance, which is linear too: turned along, it need not be summed again to
/// desaturate. Four doubles are whole vectors of any processor.
using Channels = std::array<double, 4>;

inline f64::Number3 colourOf(const Channels& v) {
  return {v[0], v[1], v[2]};
}

/// Horizontal length of the sun's direction below which the dependence on its azimuth fades. At the zenith and the
/// nadir the azimuth turns at once, and the sky does not depend on it. A rest of the dependence between a table's keys
/// would step there. The length is 2 arc seconds. A key that near loses a quarter of the length times the slope of the
/// sky's own dependence, which stays within the 1e-5 of a bake.
inline constexpr double kPoleFade = 1e-5;

/// An azimuth by its unit horizontal direction: cosine is its z, sine its x.
struct Azimuth {
  double cosine = 1.0;
  double sine = 0.0;
  double share = 1.0;  ///< in [0, 1], by which the dependence on the azimuth fades: kPoleFade

  Azimuth() = default;
  /// The azimuth of a direction's horizontal part; towards +z, with share 0, when it has none.
  explicit Azimuth(const f64::Number3& direction);
};

/// Turns coefficients of m >= 0 about the pole +y into all coefficients about the pole +z of the basis. The axes only
/// change places between the two, so every coefficient of the world is a sum of at most three. 5 bands take
/// 45 products.
class PolarFrame {
 public:
  PolarFrame();

  /// `polar`: index l (l + 1) / 2 + m, of `bands` <= 5 bands; `world`: bands^2 coefficients, axes of the world.
  void toWorld(std::size_t bands, std::span<const Channels> polar, const Azimuth& azimuth,
               std::span<Channels> world) const;

 private:
  static constexpr std::size_t kMostTerms = 45;
  /// factor times the cosine or sine of |m| times the azimuth times the coefficient (l, |m|).
  struct Term {
    double factor;
    std::uint8_t polar, turn;  ///< indices of the coefficient and of Turns
  };
  std::array<Term, kMostTerms> term_;     ///< by coefficient of the world
  std::array<std::uint8_t, 26> first_{};  ///< a coefficient's first term; the next coefficient's is its end
};

}  // namespace welkin::core
