// SPDX-License-Identifier: Apache-2.0
#include "tests/sky/some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

model::Gradient ramp(const std::vector<Number3>& rows, const std::vector<double>& columns) {
  model::Gradient gradient{static_cast<int>(columns.size()), static_cast<int>(rows.size()), {}};
  for (const Number3& row : rows)
    for (const double column : columns)
      gradient.rgb.insert(gradient.rgb.end(), {static_cast<float>(row.x), static_cast<float>(row.y * column),
                                               static_cast<float>(row.z * column * column)});
  return gradient;
}

model::Sky clearDay() {
  model::Sky sky;
  sky.luminance = {-1.0, -0.24, 18.0, -3.2, 0.35, 0.0};
  sky.intensity = {1, {5.0, 7.0, 11.0, 17.0, 19.5}, {0.02, 0.7, 1.9, 0.9, 0.02}};
  // Irregular columns, as in a painted gradient: the day bends at every one.
  const std::vector<double> columns = {0.6, 0.55, 0.62, 0.6,  0.58, 0.7,  0.9,  0.85, 0.97, 0.9, 1.0,  0.95,
                                       1.0, 0.93, 0.98, 0.85, 0.9,  0.88, 0.75, 0.8,  0.6,  0.7, 0.62, 0.66};
  sky.gradient_sun = ramp({{1.0, 0.6, 0.4}, {0.7, 0.6, 0.6}, {0.3, 0.5, 0.9}}, columns);
  sky.gradient_anti = ramp({{0.6, 0.6, 0.8}, {0.2, 0.4, 0.9}}, {0.7, 1.0, 0.9});
  sky.polarising_tint = {3, {6.0, 13.0}, {0.9, 1.0, 1.1, 0.8, 0.9, 1.0}};
  sky.sun.path = model::sunPathFromPlace(17.0, -3.5, 0.0, 2012, 172);
  return sky;
}

}  // namespace

std::vector<NamedSky> someSkies() {
  std::vector<NamedSky> list;
  list.push_back({"clear day", clearDay(), {0.0, 5.0, 6.0, 7.0, 9.0, 11.0, 14.0, 17.0, 18.5, 19.5}});
  model::Sky cusp = clearDay();
  cusp.luminance = *model::findLuminance("far-cry-3");
  cusp.sun.path.key_time_h = {4.0, 9.0, 15.0, 20.0};
  cusp.sun.path.key_azimuth_rad = {1.0, 1.6, 4.4, 5.0};
  cusp.sun.path.key_elevation_rad = {-0.2, 0.5, 0.9, -0.1};
  list.push_back({"far-cry-3 by hand", cusp, {0.0, 5.0, 7.5, 10.0, 13.0, 17.0, 19.5}});
  model::Sky layer = clearDay();
  layer.luminance = *model::findLuminance("cie-13");
  layer.normalise_to_sun = false;
  layer.intensity = {1, {6.0, 12.0, 18.0}, {0.8, 1.0, 0.8}};
  list.push_back({"cie-13", layer, {1.0, 5.0, 8.0, 12.0, 16.0, 20.0}});
  model::Sky overcast = clearDay();
  overcast.luminance = *model::findLuminance("cie-overcast");
  list.push_back({"cie-overcast", overcast, {0.0, 5.0, 7.0, 11.0, 17.0, 19.5}});
  for (NamedSky& named : list) model::normalise(named.sky.gradient_sun, named.sky.gradient_anti);
  return list;
}

}  // namespace welkin::tests
