// SPDX-License-Identifier: Apache-2.0
// Layouts of a cube's six faces in one picture: strips, OpenEXR's cube, and crosses that fold into a cube.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sh/environment.h"
#include "sky/image/image.h"

namespace welkin::cubemap {

/// Where a face lies in the picture, in units of a face, and the directions in which it is seen.
struct PlacedFace {
  int column = 0, line = 0;
  det::Number3 right, down, normal;
};

struct CubeLayout {
  std::string name;  ///< as --layout takes it
  int across = 1, down = 1;
  sh::TexelRule rule = sh::TexelRule::half_texel;
  std::array<PlacedFace, 6> face;  ///< +x -x +y -y +z -z
};

/// The layout of a name: `vstrip`, `hstrip`, `exr-cube`, or a cross. A cross is `hcross` or `vcross`, then the face in
/// its middle and the one to the right of that, both of +x -x +z -z, as in `hcross:-z+x`; +z+x if they are left out.
/// Above the middle is +y. The last face of a `vcross` hangs upside down, so that the picture folds; `:upright` after
/// it says that it stands upright as the others do. None for other names.
std::optional<CubeLayout> cubeLayout(const std::string& name);

/// Layouts that a picture of this shape may have without a name in its header, the most common one first.
std::vector<CubeLayout> layoutsOfShape(int width, int height);

/// Whether the picture has the layout's shape, and faces of at least as many texels as its rule needs.
bool fits(const CubeLayout& layout, const image::Image& image);

/// The faces within the picture. The picture must fit.
std::array<sh::CubeFace, 6> facesOf(const CubeLayout& layout, const image::Image& image);

/// Mean square of the differences across the twelve edges of the cube. It is least for the layout that the picture
/// has, unless the light is symmetric.
double seamOf(const CubeLayout& layout, const image::Image& image);

}  // namespace welkin::cubemap
