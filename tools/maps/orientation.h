// SPDX-License-Identifier: Apache-2.0
// The orientation of environment maps in each engine: where its own lookup finds each of Welkin's directions. Sources
// of the conventions are in docs/export.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sh/deterministic.h"

namespace welkin::maps {

using det::Number3;

/// The orientation of one engine's maps.
struct Orientation {
  const char* name;  ///< as --target takes it

  /// Welkin's directions that the vectors (1, 0, 0), (0, 1, 0) and (0, 0, 1) look up in a cube. The vector is the one
  /// that reaches the texture unit: after the engine's change of axes, and after a mirroring in its shader.
  Number3 x, y, z;

  /// Azimuth at the left edge of the latlong, degrees clockwise from north. Azimuths grow to the right, and the upper
  /// edge is the zenith.
  double left_azimuth_deg;
};

/// Welkin's own orientation: Vulkan's cube, and a latlong with north at its left edge.
const Orientation& welkinOrientation();

/// The orientation of an engine, by its name; none for unknown names.
std::optional<Orientation> orientationOf(std::string_view engine);

/// Names of all engines, with commas between them.
std::string engineNames();

/// Unit direction, in Welkin's world, of a point of a cube's face (0 to 5: +x -x +y -y +z -z) at (s, t), both in [0, 1]
/// from the face's upper left corner.
Number3 cubeDirection(const Orientation& orientation, int face, double s, double t);

/// Unit direction, in Welkin's world, of a point of the latlong at (u, v), both in [0, 1] from its upper left corner.
Number3 latlongDirection(const Orientation& orientation, double u, double v);

}  // namespace welkin::maps
