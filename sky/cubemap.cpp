// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap.h"

#include <Imath/half.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>

#include "sky/error.h"

namespace welkin::sky {
namespace {

constexpr float kLargestHalf = 65504.0F;

Number3 normalised(const Number3& v) {
  return v / std::sqrt(dot(v, v));
}

}  // namespace

Extent extentOf(Layout layout, int size) {
  return layout == Layout::exr_latlong ? Extent{4 * size, 2 * size} : Extent{size, 6 * size};
}

FaceAxes faceAxes(Layout layout, int face) {
  static const FaceAxes kVulkan[6] = {// Vulkan 1.3, "Cube Map Face Selection"
                                      {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                      {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                      {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  FaceAxes axes = kVulkan[face];
  // OpenEXR looks at the faces from inside in a right-handed world: the side faces are mirrored left to right, the
  // others top to bottom.
  if (layout == Layout::exr_cube) {
    Number3& mirrored = face == 2 || face == 3 ? axes.down : axes.right;
    mirrored = mirrored * -1.0;
  }
  return axes;
}

Number3 directionOfTexel(Layout layout, int size, int column, int row) {
  if (layout == Layout::exr_latlong) {
    const Extent extent = extentOf(layout, size);
    const double latitude = det::kHalfPi - det::kPi * row / (extent.height - 1);
    const double longitude = det::kPi - det::kTwoPi * column / (extent.width - 1);
    const double c = row == 0 || row == extent.height - 1 ? 0.0 : det::cos(latitude);
    return normalised({det::sin(longitude) * c, det::sin(latitude), det::cos(longitude) * c});
  }
  const FaceAxes axes = faceAxes(layout, row / size);
  const auto coordinate = [&](int i) {
    return layout == Layout::vulkan_cube ? (2.0 * i + 1.0) / size - 1.0 : 2.0 * i / (size - 1) - 1.0;
  };
  return normalised(axes.normal + axes.right * coordinate(column) + axes.down * coordinate(row % size));
}

DomeImage renderDome(const SkyInstant& instant, const Number3& ground, Layout layout, int size,
                     const Progress& progress) {
  DomeImage image{extentOf(layout, size), {}, 0};
  const auto width = static_cast<std::size_t>(image.extent.width);
  image.rgb_half.resize(width * static_cast<std::size_t>(image.extent.height) * 3);
  std::atomic<std::size_t> saturated = 0;
  tbb::parallel_for(0, image.extent.height, [&](int row) {
    std::size_t past = 0;
    std::uint16_t* out = image.rgb_half.data() + static_cast<std::size_t>(row) * width * 3;
    for (int column = 0; column < image.extent.width; ++column) {
      const Number3 radiance = instant.dome(directionOfTexel(layout, size, column, row), ground);
      for (int c = 0; c < 3; ++c) {
        if (radiance[c] > double{kLargestHalf}) ++past;
        *out++ = Imath::half(static_cast<float>(std::min(radiance[c], double{kLargestHalf}))).bits();
      }
    }
    saturated += past;
    if (progress && !progress()) throw Error(ExitStatus::interrupted, "interrupted; finished files are kept");
  });
  image.saturated = saturated;
  return image;
}

}  // namespace welkin::sky
