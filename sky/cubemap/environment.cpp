// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sky/base/error.h"
#include "sky/cubemap/cubemap.h"
#include "sky/image/image.h"

namespace welkin::cubemap {
namespace {

constexpr image::ImageLimits kLimits{65536, std::size_t{1} << 27, true};

/// Places of the faces +x -x +y -y +z -z in a picture, in units of a face; -z of the vertical cross hangs upside down.
struct CubeLayout {
  const char* name;
  int across, down;
  std::array<std::array<int, 2>, 6> place;
};
constexpr CubeLayout kCubeLayouts[] = {
    {"strip", 1, 6, {{{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}}},
    {"strip", 6, 1, {{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}}},
    {"cross", 4, 3, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}}},
    {"cross", 3, 4, {{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}}},
};

std::array<sh::CubeFace, 6> facesOf(const image::Image& image, const CubeLayout& layout, Layout orientation, int size) {
  std::array<sh::CubeFace, 6> faces;
  const std::ptrdiff_t row = std::ptrdiff_t{3} * image.width;
  for (std::size_t f = 0; f < 6; ++f) {
    const auto [column, line] = layout.place[f];
    FaceAxes axes = faceAxes(orientation, static_cast<int>(f));
    if (layout.across == 3 && f == 5) {
      axes.right = axes.right * -1.0;
      axes.down = axes.down * -1.0;
    }
    faces[f] = {image.rgb.data() + line * size * row + std::ptrdiff_t{3} * column * size, row, axes.right, axes.down,
                axes.normal};
  }
  return faces;
}

}  // namespace

Environment projectImage(const std::filesystem::path& path, int bands) {
  const image::Image image = image::readImage(path, kLimits);
  const auto refuse = [&](const char* what) {
    return base::Error(base::ExitStatus::content,
                       fmt::format("{}: {} x {} texels: {}", path.string(), image.width, image.height, what));
  };
  Environment result;
  result.negative =
      static_cast<std::size_t>(std::count_if(image.rgb.begin(), image.rgb.end(), [](float v) { return v < 0.0F; }));
  result.width = image.width;
  result.height = image.height;
  if (image.envmap != image::EnvironmentMap::none) result.rule = sh::TexelRule::edge_centres;

  const bool two_to_one = image.envmap == image::EnvironmentMap::none && image.width == 2 * image.height;
  if (image.envmap == image::EnvironmentMap::latlong || two_to_one) {
    if (result.rule == sh::TexelRule::edge_centres && std::min(image.width, image.height) < 2)
      throw refuse("OpenEXR's latlong has at least 2 columns and rows");
    result.layout = "latlong";
    result.radiance_sh = sh::projectLatlong(image.rgb.data(), image.width, image.height, result.rule, bands);
    return result;
  }
  for (const CubeLayout& layout : kCubeLayouts) {
    const int size = image.width / layout.across;
    if (image.width != size * layout.across || image.height != size * layout.down) continue;
    const bool exr = image.envmap == image::EnvironmentMap::cube;
    if (exr && (layout.down != 6 || size < 2)) break;
    result.layout = exr ? "cube" : layout.name;
    result.width = result.height = size;
    result.radiance_sh = sh::projectCube(facesOf(image, layout, exr ? Layout::exr_cube : Layout::vulkan_cube, size),
                                         size, result.rule, bands);
    return result;
  }
  throw refuse(image.envmap == image::EnvironmentMap::cube
                   ? "OpenEXR's cube is six faces of 2 or more texels below each other, 1:6"
                   : "a latlong is 2:1, a cubemap 1:6, 6:1, 4:3 or 3:4");
}

}  // namespace welkin::cubemap
