// SPDX-License-Identifier: Apache-2.0
// Tells where albedo is none that a diffuse dielectric is likely to have. Charcoal and snow exist: it warns.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "calibrate/reference_chart.h"
#include "sky/image/image.h"

namespace welkin::calibrate {

/// Codes of sRGB, of 255, that the luminance of a dielectric's base colour is likely to have (W. McDermott, "The PBR
/// Guide", part 2, Allegorithmic 2018, "tolerant range").
inline constexpr double kDarkestCode = 30.0, kBrightestCode = 240.0;

/// The chromaticities x and y between those of a chart's patches: their convex hull.
class Gamut {
 public:
  explicit Gamut(const ReferenceChart& reference);

  /// Whether linear Rec. 709 lies within, or outside by less than `kMargin` in x and y. Black has no chromaticity.
  bool holds(const Colour& rgb) const;

  /// A code of 8 bits has so much uncertainty at the darkest code: half a code of 30 is 1 part in 27 of light, which
  /// moves x or y by up to 1 / 27 / 3.
  static constexpr double kMargin = 0.012;

 private:
  std::vector<Eigen::Vector2d> corners_;  ///< x to y is counter-clockwise
};

/// Texels of an albedo, as parts of all. A dark texel counts once: it is not outside the gamut as well.
struct AlbedoShares {
  double dark = 0.0;
  double bright = 0.0;
  double outside = 0.0;

  double wrong() const { return dark + bright + outside; }
};

/// Of linear Rec. 709 texels, each times the tint. No texel: all shares are 0.
AlbedoShares sharesOf(const image::Image& albedo, const Colour& tint, const Gamut& gamut);

/// A material or a picture by its name.
struct CheckedAlbedo {
  std::string name;
  AlbedoShares shares;
};

/// The worst first; those of the same share by name.
void sortByWrong(std::vector<CheckedAlbedo>& checked);

/// {"albedo": [{"name", "dark", "bright", "outside"}], "limits": {...}, "allowed", "passed"}: passed tells whether no
/// albedo has more than the part `allowed` of wrong texels.
nlohmann::ordered_json checkJson(const std::vector<CheckedAlbedo>& checked, double allowed);

}  // namespace welkin::calibrate
