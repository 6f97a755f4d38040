// SPDX-License-Identifier: Apache-2.0
#include "bounds.h"

namespace welkin::numerics {

const std::vector<Bound>& bounds() {
  static const std::vector<Bound> kBounds = {
      {"directionOf", 0.81, 1.09},        {"sineFromCosine", 1.38, 1.38},
      {"horizontalLength", 1.25, 1.25},   {"elevationOf", 2.23, 382.3},
      {"angleBetween", 3.34, 383.0},      {"angleBetween_opposite", 3.27, 382.1},
      {"celestialDirection", 1.67, 1.7},  {"equatorialOf", 1.28, 1.28},
      {"starCoordinates", 2.93, 10.0},    {"discCoverage", 4.63, 4.63},
      {"moonPhase", 589.1, 589.1},        {"ditherAt", 0.0, 0.0},
      {"expMinusOne", 0.83, 5.27},        {"gradation_clear", 1.6, 6.07},
      {"gradation_thin", 2.02, 5.38},     {"gradation_overcast", 1.86, 3.05},
      {"gradation_strong", 8.89, 15.3},   {"indicatrix_clear", 2.6, 5.08},
      {"indicatrix_delta", 6.8, 7.69},    {"indicatrix_strong", 9.56, 13.6},
      {"constantNorm_sun", 0.63, 0.63},   {"constantNorm_zenith", 0.57, 0.54},
      {"luminanceNorm_sun", 3.25, 4.97},  {"luminanceNorm_zenith", 5.3, 130.4},
      {"relativeLuminance", 5.76, 133.5}, {"luminanceOf", 2.04, 2.04},
      {"normalIrradiance", 3.61, 3.61},   {"levelIrradiance", 0.55, 0.55},
      {"groundRadiance", 1.76, 1.76},     {"chromaticity", 2.74, 2.74},
      {"desaturate", 2.28, 2.28},         {"srgbDecode", 6.31, 12.8},
      {"srgbEncode", 3.18, 10.1},         {"gradientColumn", 0.76, 0.76},
      {"gradientRow", 0.53, 0.53},        {"azimuthWeight", 1.52, 1.52},
      {"starFade", 1.18, 1.18},           {"shBasis", 5.33, 5.73},
      {"cosineLobe", 0.41, 0.41},         {"groundLobe", 0.41, 0.41},
      {"transferBasis", 0.28, 0.28},      {"transferWeights", 1.64, 1.64},
  };
  return kBounds;
}

}  // namespace welkin::numerics
