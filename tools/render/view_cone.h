// SPDX-License-Identifier: Apache-2.0
// Which instances of a scene a perspective can see, by spheres about them.
#pragma once

#include <array>
#include <vector>

#include "probes/level/scene.h"

namespace welkin::render {

struct Sphere {
  f64::Number3 middle{0.0};  ///< metres, world axes
  double radius = 0.0;       ///< metres
  double scale = 1.0;        ///< largest stretch of the mesh by its placing
};

/// A sphere about each instance of the scene's draws; those of no draw have radius 0.
std::vector<Sphere> instanceSpheres(const level::Scene& scene);

class ViewCone {
 public:
  /// `view` is the column-major matrix from world to device coordinates, with x and y in [-1, 1] and w along the axis.
  explicit ViewCone(const float (&view)[16]);

  /// False only where no point of the sphere is in the picture.
  bool sees(const Sphere& sphere) const;
  /// The share of the picture's height that a metre has at the sphere's nearest point, at most; infinite where the eye
  /// is within the sphere.
  double heightOfMetre(const Sphere& sphere) const;

 private:
  struct Plane {
    f64::Number3 normal{0.0};
    double offset = 0.0, length = 0.0;
  };
  double metre_ = 0.0;           ///< share of the picture's height that a metre has, a metre away
  std::array<Plane, 5> planes_;  ///< left, right, top, bottom, and the eye's own
};

}  // namespace welkin::render
