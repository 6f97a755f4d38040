// SPDX-License-Identifier: Apache-2.0
// Maps of a baked sky at one time, texel by texel from the runtime's dome: the tinted sky and the ground, without sun,
// moon and stars. Every texel is evaluated in the direction of its own centre.
#pragma once

#include <welkin/welkin.h>

#include <functional>
#include <vector>

#include "maps/orientation.h"

namespace welkin::maps {

/// Linear RGB radiance in scene units, rows from the top.
struct Map {
  int width = 0, height = 0;
  std::vector<float> rgb;
};

/// Radiance in a unit direction of Welkin's world. Called from many threads.
using Light = std::function<Number3(const Number3&)>;

/// The dome of a sky. Sky and sample outlive the result.
Light domeOf(const WelkinSky* sky, const WelkinSkySample& sample);

/// A cube of any light at its texels' centres, as renderCube, and a latlong, as renderLatlong.
Map cubeOf(const Light& light, const Orientation& orientation, int size);
Map latlongOf(const Light& light, const Orientation& orientation, int height);

/// The faces +x -x +y -y +z -z of an engine's cube, size x size texels each, stacked downwards. `sample` comes from the
/// same sky. Parallel over rows; the bytes do not depend on the number of threads.
Map renderCube(const WelkinSky* sky, const WelkinSkySample& sample, const Orientation& orientation, int size);

/// An engine's latlong of 2 height x height texels, likewise.
Map renderLatlong(const WelkinSky* sky, const WelkinSkySample& sample, const Orientation& orientation, int height);

/// The next mip of a cube: every texel is the mean of 2 x 2. Of an odd size the last row and column of each face are
/// left out. The cube's faces are stacked and larger than one texel.
Map nextMip(const Map& cube);

/// One face of a stacked cube.
Map faceOf(const Map& cube, int face);

}  // namespace welkin::maps
