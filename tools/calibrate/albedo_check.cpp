// SPDX-License-Identifier: Apache-2.0
#include "calibrate/albedo_check.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sh/deterministic.h"
#include "sky/base/message.h"

namespace welkin::calibrate {
namespace {

using Chromaticity = Eigen::Vector2d;

double turn(const Chromaticity& a, const Chromaticity& b, const Chromaticity& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The convex hull, counter-clockwise (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions",
/// Information Processing Letters 9, 1979).
std::vector<Chromaticity> hullOf(std::vector<Chromaticity> points) {
  std::sort(points.begin(), points.end(), [](const Chromaticity& a, const Chromaticity& b) {
    return std::tuple(a.x(), a.y()) < std::tuple(b.x(), b.y());
  });
  std::vector<Chromaticity> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Chromaticity& p : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // the other side begins with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

Gamut::Gamut(const ReferenceChart& reference) {
  std::vector<Chromaticity> points;
  for (const Colour& c : reference) points.push_back(xyYOfXyz(xyzOfRgb(c)).head<2>());
  corners_ = hullOf(std::move(points));
}

bool Gamut::holds(const Colour& rgb) const {
  const Chromaticity at = xyYOfXyz(xyzOfRgb(rgb)).head<2>();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Chromaticity& a = corners_[i];
    const Chromaticity& b = corners_[(i + 1) % corners_.size()];
    if (turn(a, b, at) < -kMargin * (b - a).norm()) return false;
  }
  return true;
}

AlbedoShares sharesOf(const image::Image& albedo, const Colour& tint, const Gamut& gamut) {
  const double darkest = det::srgbDecode(kDarkestCode / 255.0), brightest = det::srgbDecode(kBrightestCode / 255.0);
  std::size_t dark = 0, bright = 0, outside = 0;
  const std::size_t texels = albedo.rgb.size() / 3;
  for (std::size_t i = 0; i < texels; ++i) {
    const float* c = albedo.rgb.data() + 3 * i;
    const Colour rgb = Colour(double{c[0]}, double{c[1]}, double{c[2]}).cwiseProduct(tint);
    const double luminance = xyzOfRgb(rgb).y();
    if (!(luminance >= darkest))
      ++dark;
    else if (luminance > brightest)
      ++bright;
    else if (!gamut.holds(rgb))
      ++outside;
  }
  const double all = static_cast<double>(std::max<std::size_t>(1, texels));
  return {static_cast<double>(dark) / all, static_cast<double>(bright) / all, static_cast<double>(outside) / all};
}

void sortByWrong(std::vector<CheckedAlbedo>& checked) {
  std::sort(checked.begin(), checked.end(), [](const CheckedAlbedo& a, const CheckedAlbedo& b) {
    return std::tuple(-a.shares.wrong(), a.name) < std::tuple(-b.shares.wrong(), b.name);
  });
}

nlohmann::ordered_json checkJson(const std::vector<CheckedAlbedo>& checked, double allowed) {
  nlohmann::ordered_json json = {{"albedo", nlohmann::ordered_json::array()}};
  bool passed = true;
  for (const CheckedAlbedo& c : checked) {
    json["albedo"].push_back({{"name", base::oneLine(c.name)},
                              {"dark", c.shares.dark},
                              {"bright", c.shares.bright},
                              {"outside", c.shares.outside}});
    passed = passed && c.shares.wrong() <= allowed;
  }
  json["limits"] = {
      {"darkest_srgb", kDarkestCode}, {"brightest_srgb", kBrightestCode}, {"gamut_margin_xy", Gamut::kMargin}};
  json["allowed"] = allowed;
  json["passed"] = passed;
  return json;
}

}  // namespace welkin::calibrate
