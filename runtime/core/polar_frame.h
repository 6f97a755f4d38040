// SPDX-License-Identifier: Apache-2.0
// From the frame of the sun's azimuth, in which the day's table is, to the world's spherical harmonics.
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

/// Horizontal length of the sun's direction below which what depends on its azimuth fades. At the zenith and the nadir
/// the azimuth turns at once, and the sky does not depend on it; what a table has left of that between its keys would
/// step. It is so near (2 arc seconds) that what a key there loses of the sky's own dependence, a quarter of the length
/// times its slope, stays within the 1e-5 of a bake.
inline constexpr double kPoleFade = 1e-5;

/// An azimuth by its unit horizontal direction: cosine is its z, sine its x.
struct Azimuth {
  double cosine = 1.0;
  double sine = 0.0;
  double share = 1.0;  ///< in [0, 1], of what depends on the azimuth: kPoleFade

  Azimuth() = default;
  /// Of a direction's horizontal part; towards +z, with share 0, when it has none.
  explicit Azimuth(const f64::Number3& direction);
};

/// Turns coefficients of m >= 0 about the pole +y into all coefficients about the pole +z of the basis. The axes only
/// change places between the two, so every coefficient of the world is a sum of at most three: of 5 bands, 45 products.
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
  std::array<std::uint8_t, 26> first_{};  ///< of a coefficient's terms; the next one's is their end
};

}  // namespace welkin::core
