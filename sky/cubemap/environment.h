// SPDX-License-Identifier: Apache-2.0
// Pictures of the whole sphere from files, in the layouts that tools write, as spherical harmonics.
#pragma once

#include <filesystem>
#include <string>

#include "sh/environment.h"

namespace welkin::cubemap {

/// A cubemap's or latlong's radiance, and how the file was understood.
struct Environment {
  std::string layout;  ///< "cube", "strip", "cross" or "latlong"
  sh::TexelRule rule = sh::TexelRule::half_texel;
  int width = 0;                          ///< the latlong's, or a face's
  int height = 0;                         ///< the same
  std::size_t negative = 0;               ///< values below 0
  std::vector<det::Number3> radiance_sh;  ///< bands^2, world axes
};

/// Reads and projects an image. With OpenEXR's `envmap` attribute it follows OpenEXR's rule and orientation (texel
/// centres on edges and poles); without, the half-texel rule, and its shape tells the layout: 2:1 a latlong that lies
/// as OpenEXR's does; 1:6 or 6:1 faces +x -x +y -y +z -z and 4:3 or 3:4 the usual crosses, faces oriented as Vulkan's.
/// `bands` in [1, sh::kMostBands]. Throws Error as readImage does, and Error(content) for another shape.
Environment projectImage(const std::filesystem::path& path, int bands);

}  // namespace welkin::cubemap
