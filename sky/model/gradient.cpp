// SPDX-License-Identifier: Apache-2.0
#include "sky/model/gradient.h"

#include <algorithm>
#include <cmath>

#include "format/cubemap_format.h"

namespace welkin::model {

Gradient Gradient::constant(const Number3& colour) {
  return {1, 1, {static_cast<float>(colour.x), static_cast<float>(colour.y), static_cast<float>(colour.z)}};
}

Number3 Gradient::texel(int column, int row) const {
  const float* p = rgb.data() + 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(column));
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

double Gradient::brightestLuminance() const {
  double brightest = 0.0;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) brightest = std::max(brightest, det::luminanceOf(texel(i, j)));
  return brightest;
}

Number3 GradientColumn::at(double elevation_rad) const {
  const double y = det::gradientRow(elevation_rad, static_cast<double>(row.size()));
  const auto low = static_cast<std::size_t>(y);
  const std::size_t high = std::min(low + 1, row.size() - 1);
  return mix(row[low], row[high], y - static_cast<double>(low));
}

bool GradientColumn::bendsAt(int j) const {
  const auto i = static_cast<std::size_t>(j);
  const Number3& below = row[i > 0 ? i - 1 : 0];
  const Number3& above = row[std::min(i + 1, row.size() - 1)];
  const Number3 bend = above - row[i] * 2.0 + below;
  const double size = row[i].x + row[i].y + row[i].z;
  return std::abs(bend.x) + std::abs(bend.y) + std::abs(bend.z) > 1e-9 * size;
}

GradientColumn columnAt(const Gradient& gradient, double time_h) {
  const double x = det::gradientColumn(format::wrapTime(time_h), gradient.width);
  const double left = std::floor(x);
  const auto wrap = [&](double i) {
    return static_cast<int>(i < 0.0 ? i + gradient.width : i >= gradient.width ? i - gradient.width : i);
  };
  const int c0 = wrap(left);
  const int c1 = wrap(left + 1.0);
  GradientColumn column;
  for (int j = 0; j < gradient.height; ++j)
    column.row.push_back(mix(gradient.texel(c0, j), gradient.texel(c1, j), x - left));
  return column;
}

Gradient rounded(const Gradient& gradient, GradientFormat texel_format) {
  Gradient result = gradient;
  if (texel_format == GradientFormat::rgb32f) return result;
  for (std::size_t i = 0; i < result.rgb.size(); i += 3) {
    float rgb[3] = {result.rgb[i], result.rgb[i + 1], result.rgb[i + 2]};
    unsigned char texel[format::kMostTexelBytes];
    format::encodeTexel(format::CubemapFormat::rgb9e5, rgb, texel);
    format::decodeTexel(format::CubemapFormat::rgb9e5, texel, rgb);
    std::copy_n(rgb, 3, result.rgb.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return result;
}

void normalise(Gradient& a, Gradient& b) {
  const double brightest = std::max(a.brightestLuminance(), b.brightestLuminance());
  if (!(brightest > 0.0)) return;
  for (Gradient* gradient : {&a, &b})
    for (float& v : gradient->rgb) v = static_cast<float>(double{v} / brightest);
}

}  // namespace welkin::model
