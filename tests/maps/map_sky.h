// SPDX-License-Identifier: Apache-2.0
// A baked sky without any symmetry, for tests of maps.
#pragma once

#include "tests/sky/baked.h"

namespace welkin::tests {

/// A clear sky over a coloured ground, its sun at azimuth 74.4 and elevation 33 degrees. It stands well within a texel
/// of cubes of 32 texels and latlongs of 64 x 32.
inline model::Sky mapSky() {
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-12");
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {74.4 * det::kDegree};
  sky.sun.path.key_elevation_rad = {33.0 * det::kDegree};
  sky.ground_albedo = det::Number3(0.3, 0.2, 0.1);
  return sky;
}

/// That sky in the runtime, sampled.
struct MapSky {
  Baked baked{mapSky(), 3, 1};
  WelkinSkySample sample{};

  MapSky() { baked.sky.sample(0.0, sample); }
  const WelkinSky* get() const { return baked.sky.get(); }
  det::Number3 sun() const {
    const float* d = sample.sun.direction;
    return {double{d[0]}, double{d[1]}, double{d[2]}};
  }
};

}  // namespace welkin::tests
