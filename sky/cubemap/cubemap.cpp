// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap.h"

#include <Imath/half.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <optional>

#include "sky/base/error.h"

namespace welkin::cubemap {
namespace {

constexpr float kLargestHalf = 65504.0F;

Number3 normalised(const Number3& v) {
  return v * (1.0 / std::sqrt(dot(v, v)));
}

/// Coordinate of a cube's column or row, in [-1, 1].
double faceCoordinate(Layout layout, int size, int i) {
  return layout == Layout::vulkan_cube ? (2.0 * i + 1.0) / size - 1.0 : 2.0 * i / (size - 1) - 1.0;
}

/// Cosine and sine of an angle.
struct Turn {
  double cosine, sine;
};

/// Cosine and sine of the latitude of a latlong's row.
Turn circleOfRow(const Extent& extent, int row) {
  const double latitude = det::kHalfPi - det::kPi * row / (extent.height - 1);
  return {row == 0 || row == extent.height - 1 ? 0.0 : det::cos(latitude), det::sin(latitude)};
}

/// Cosine and sine of the longitude of its column, from +z towards +x.
Turn turnOfColumn(const Extent& extent, int column) {
  const double longitude = det::kPi - det::kTwoPi * column / (extent.width - 1);
  return {det::cos(longitude), det::sin(longitude)};
}

Number3 directionOn(const Turn& circle, const Turn& turn) {
  return normalised({turn.sine * circle.cosine, circle.sine, turn.cosine * circle.cosine});
}

/// The directions of a row's texels.
class RowDirections {
 public:
  RowDirections(Layout layout, int size) : layout_(layout), size_(size), extent_(extentOf(layout, size)) {
    if (layout == Layout::exr_latlong)
      for (int column = 0; column < extent_.width; ++column) turn_.push_back(turnOfColumn(extent_, column));
  }
  template <typename Visit>
  void forEach(int row, Visit&& visit) const {
    if (layout_ == Layout::exr_latlong) {
      const Turn circle = circleOfRow(extent_, row);
      for (const Turn& turn : turn_) visit(directionOn(circle, turn));
    } else {
      const FaceAxes axes = faceAxes(layout_, row / size_);
      const Number3 middle = axes.normal + axes.down * faceCoordinate(layout_, size_, row % size_);
      for (int column = 0; column < size_; ++column)
        visit(normalised(middle + axes.right * faceCoordinate(layout_, size_, column)));
    }
  }

 private:
  Layout layout_;
  int size_;
  Extent extent_;
  std::vector<Turn> turn_;
};

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
  if (layout == Layout::exr_latlong)
    return directionOn(circleOfRow(extentOf(layout, size), row), turnOfColumn(extentOf(layout, size), column));
  const FaceAxes axes = faceAxes(layout, row / size);
  return normalised(axes.normal + axes.down * faceCoordinate(layout, size, row % size) +
                    axes.right * faceCoordinate(layout, size, column));
}

namespace {

/// Calls store(index of texel, radiance), which returns how many components it saturated, in parallel over rows.
/// Returns the sum.
template <typename Store>
std::size_t render(const model::SkyInstant& instant, const Number3& ground, Layout layout, int size,
                   const base::Progress& progress, Store&& store) {
  const model::LuminanceModel& model = instant.sky().luminance;
  std::optional<model::IndicatrixTable> table;
  if (model.d >= -model::IndicatrixTable::kSteepest) table.emplace(model.d);
  const RowDirections directions(layout, size);
  const Extent extent = extentOf(layout, size);
  std::atomic<std::size_t> saturated = 0;
  tbb::parallel_for(0, extent.height, [&](int row) {
    std::size_t past = 0;
    std::size_t texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(extent.width);
    directions.forEach(row, [&](const Number3& direction) {
      past += store(texel++, instant.dome(direction, ground, table ? &*table : nullptr));
    });
    saturated += past;
    progress.check();
  });
  return saturated;
}

std::size_t texelCount(const Extent& extent) {
  return static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height);
}

}  // namespace

DomeImage renderDome(const model::SkyInstant& instant, const Number3& ground, Layout layout, int size,
                     const base::Progress& progress) {
  DomeImage image{extentOf(layout, size), {}, 0};
  image.rgb_half.resize(texelCount(image.extent) * 3);
  image.saturated = render(instant, ground, layout, size, progress, [&](std::size_t texel, const Number3& radiance) {
    std::size_t past = 0;
    for (int c = 0; c < 3; ++c) {
      if (radiance[c] > double{kLargestHalf}) ++past;
      image.rgb_half[texel * 3 + static_cast<std::size_t>(c)] =
          Imath::half(static_cast<float>(std::min(radiance[c], double{kLargestHalf}))).bits();
    }
    return past;
  });
  return image;
}

Cubemap renderCubemap(const model::SkyInstant& instant, const Number3& ground, int size, format::CubemapFormat format,
                      const base::Progress& progress) {
  const std::size_t bytes = format::texelBytes(format);
  Cubemap cubemap{size, format, {}, 0};
  cubemap.texels.resize(texelCount(extentOf(Layout::vulkan_cube, size)) * bytes);
  cubemap.saturated =
      render(instant, ground, Layout::vulkan_cube, size, progress, [&](std::size_t texel, const Number3& radiance) {
        const float rgb[3] = {static_cast<float>(radiance.x), static_cast<float>(radiance.y),
                              static_cast<float>(radiance.z)};
        return format::encodeTexel(format, rgb, cubemap.texels.data() + texel * bytes);
      });
  return cubemap;
}

long millisecondOf(double time_h) {
  return std::min(std::lround(time_h * 3600000.0), 86399999L);
}

}  // namespace welkin::cubemap
