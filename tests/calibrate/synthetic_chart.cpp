// SPDX-License-Identifier: Apache-2.0
#include "synthetic_chart.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"

namespace welkin::tests {

using namespace calibrate;
namespace {

/// From pixels to the plane of the chart.
Eigen::Matrix3d toPlane(const ChartPlace& place) {
  const auto corner = [&](double x, double y) -> Eigen::Vector3d { return place.pixelOf(x, y).homogeneous(); };
  // Columns are the images of (0, 0), (w, 0) and (0, h), scaled so that they sum to that of (w, h): four points
  // suffice.
  Eigen::Matrix3d images;
  images << corner(0.0, 0.0), corner(kChartWidth, 0.0), corner(0.0, kChartHeight);
  const Eigen::Vector3d s = images.inverse() * corner(kChartWidth, kChartHeight);
  Eigen::Matrix3d model;
  model << 0.0, kChartWidth, 0.0, 0.0, 0.0, kChartHeight, 1.0, 1.0, 1.0;
  const Eigen::Vector3d m = model.inverse() * Eigen::Vector3d(kChartWidth, kChartHeight, 1.0);
  return (images * s.asDiagonal()) * (model * m.asDiagonal()).inverse();
}

Colour throughLens(const Camera& camera, const Colour& albedo, double light) {
  const Colour seen = camera.matrix * (light * albedo);
  return seen.unaryExpr([&](double v) { return std::pow(std::max(v, 0.0), camera.exponent); });
}

}  // namespace

Colour chartAlbedo(const ReferenceChart& reference, double x, double y) {
  constexpr double kBlackRim = 0.7;
  if (x < -kBlackRim || y < -kBlackRim || x > kChartWidth + kBlackRim || y > kChartHeight + kBlackRim)
    return Colour::Constant(0.45);
  const double column = std::floor((x - kRim) / kPatchStep), row = std::floor((y - kRim) / kPatchStep);
  const bool within = column >= 0.0 && column < 6.0 && row >= 0.0 && row < 4.0 &&
                      x - kRim - column * kPatchStep <= kPatchSide && y - kRim - row * kPatchStep <= kPatchSide;
  if (!within) return Colour::Constant(0.02);
  return reference[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
}

image::Image photograph(const ReferenceChart& reference, const Scene& scene, const Camera& camera) {
  const ChartPlace place = *ChartPlace::of(scene.corners);
  const Eigen::Matrix3d plane = toPlane(place).inverse();
  std::mt19937_64 random(scene.seed);
  image::Image image;
  image.width = scene.width;
  image.height = scene.height;
  const auto normal = [&] {  // Box and Muller: the library's own distribution differs between compilers
    const double u = (static_cast<double>(random() >> 11U) + 1.0) * 0x1p-53,
                 v = static_cast<double>(random() >> 11U) * 0x1p-53;
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
  };
  for (int row = 0; row < scene.height; ++row)
    for (int column = 0; column < scene.width; ++column) {
      const Eigen::Vector2d p = (plane * Eigen::Vector3d(column + 0.5, row + 0.5, 1.0)).hnormalized();
      const double dx = (2.0 * column - scene.width) / scene.width, dy = (2.0 * row - scene.height) / scene.height;
      const double light = (1.0 - camera.vignette * 0.5 * (dx * dx + dy * dy)) *
                           std::max(0.0, 1.0 - camera.gradient * (p.x() / kChartWidth));
      const Colour seen = throughLens(camera, chartAlbedo(reference, p.x(), p.y()), light);
      for (int c = 0; c < 3; ++c) {
        double code = det::srgbEncode(std::clamp(seen[c], 0.0, 1.0));
        if (camera.noise > 0.0) code = std::clamp(code + camera.noise * normal(), 0.0, 1.0);
        if (camera.quantised) code = std::round(255.0 * code) / 255.0;
        image.rgb.push_back(static_cast<float>(det::srgbDecode(code)));
      }
    }
  return image;
}

TwoCharts photographTwo(const ReferenceChart& reference, const Camera& left, const Camera& right) {
  TwoCharts two;
  two.left.corners = {Point(40.0, 150.0), Point(290.0, 150.0), Point(290.0, 320.0), Point(40.0, 320.0)};
  two.right.corners = {Point(350.0, 150.0), Point(600.0, 150.0), Point(600.0, 320.0), Point(350.0, 320.0)};
  two.image = photograph(reference, two.left, left);
  const image::Image other = photograph(reference, two.right, right);
  for (std::size_t i = 0; i < other.rgb.size(); ++i)
    if (i / 3 % 640 >= 320) two.image.rgb[i] = other.rgb[i];
  return two;
}

void writeCoded(const std::filesystem::path& path, const image::Image& image) {
  std::vector<std::uint8_t> code;
  for (const float v : image.rgb)
    code.push_back(static_cast<std::uint8_t>(std::lround(255.0 * det::srgbEncode(double{v}))));
  base::writeFile(path, image::encodePng(image.width, image.height, code));
}

Patches seenPatches(const ReferenceChart& reference, const Camera& camera) {
  Patches patches;
  for (std::size_t i = 0; i < kPatches; ++i) patches[i].mean = throughLens(camera, reference[i], 1.0);
  return patches;
}

Eigen::Matrix3d leakyMatrix() {
  Eigen::Matrix3d m;
  m << 0.55, 0.22, 0.05, 0.12, 0.60, 0.10, 0.02, 0.14, 0.42;
  return m;
}

}  // namespace welkin::tests
