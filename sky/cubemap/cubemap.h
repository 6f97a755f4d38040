// SPDX-License-Identifier: Apache-2.0
// Pictures of the whole dome at an instant: as a Vulkan cube, as OpenEXR's cube and as OpenEXR's latlong. The sky is
// evaluated at every texel's own direction, so that no layout is resampled from another.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "format/cubemap_format.h"
#include "sky/base/progress.h"
#include "sky/table/day_table.h"

namespace welkin::cubemap {

using det::Number3;

enum class Layout {
  vulkan_cube,  ///< faces +x -x +y -y +z -z of N x N, texel centres at (i + 1/2) / N, Vulkan's face coordinates
  exr_cube,     ///< the same faces in OpenEXR's orientation, the outer texel centres on the edges (ImfEnvmap.h)
  exr_latlong   ///< 4 N x 2 N, centre +z, +x to its left, the outer columns both -z, the outer rows the poles
};

/// Size in texels of a layout for cube faces of N texels; faces are stacked downwards.
struct Extent {
  int width, height;
};
Extent extentOf(Layout layout, int size);

/// The directions in which a face of a cube layout is seen: the point (s, t), both in [-1, 1], s growing with columns
/// and t with rows, lies towards normal + s right + t down.
struct FaceAxes {
  Number3 right, down, normal;
};
FaceAxes faceAxes(Layout layout, int face);

/// Unit direction of a texel's centre; rows count from the top of the stacked image. Size >= 2 for the OpenEXR layouts.
Number3 directionOfTexel(Layout layout, int size, int column, int row);

/// RGB half floats of the dome: tint and ground in, sun and moon not.
struct DomeImage {
  Extent extent;
  std::vector<std::uint16_t> rgb_half;
  std::size_t saturated = 0;  ///< components past half's largest value, 65504, stored as that
};

/// Renders the dome in parallel over rows; the same bytes for any number of threads. `progress` is asked after every
/// row, as in bakeDayTable.
DomeImage renderDome(const model::SkyInstant& instant, const Number3& ground, Layout layout, int size,
                     const base::Progress& progress = {});

/// A cubemap as sky.welkin holds it: Layout::vulkan_cube, texel after texel.
struct Cubemap {
  int size = 0;
  format::CubemapFormat format = format::CubemapFormat::rgba16f;
  std::vector<std::uint8_t> texels;
  std::size_t saturated = 0;  ///< components past the format's largest value, stored as that
};

/// Renders the dome into the texels of a format, each rounded once; parallel and deterministic as renderDome.
Cubemap renderCubemap(const model::SkyInstant& instant, const Number3& ground, int size, format::CubemapFormat format,
                      const base::Progress& progress = {});

/// The whole millisecond of the day, 0 to 86399999, that names the cubemap of a time in [0, 24).
long millisecondOf(double time_h);

}  // namespace welkin::cubemap
