// SPDX-License-Identifier: Apache-2.0
#include "sky/table/day_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "sky/base/error.h"

namespace welkin::table {

using det::Number3;

const char* nameOf(Reconstruction reconstruction) {
  switch (reconstruction) {
    case Reconstruction::projected:
      return "projected";
    case Reconstruction::fitted:
      return "fitted";
    case Reconstruction::modes:
      break;
  }
  return "modes";
}

bool isGrey(const model::Sky& sky) {
  const auto grey = [](const model::Gradient& gradient) {
    for (std::size_t i = 0; i < gradient.rgb.size(); i += 3)
      if (gradient.rgb[i] != gradient.rgb[i + 1] || gradient.rgb[i] != gradient.rgb[i + 2]) return false;
    return true;
  };
  return grey(sky.gradient_sun) && grey(sky.gradient_anti);
}

bool hasGround(const model::Sky& sky) {
  return sky.ground_albedo.x > 0.0 || sky.ground_albedo.y > 0.0 || sky.ground_albedo.z > 0.0;
}

DayTable bakeDayTable(const model::Sky& sky, int bands, const std::vector<double>& key_time_h,
                      const base::Progress& progress, double tolerance) {
  DayTable table;
  table.bands = bands;
  table.channels = isGrey(sky) ? 1 : 3;
  const std::size_t coefficients = model::polarIndex(bands, 0);
  table.rows = static_cast<int>(coefficients) + (hasGround(sky) ? 1 : 0);
  table.key_time_h = key_time_h;
  table.number.resize(key_time_h.size() * table.numbersOfKey());
  const model::SkyProjector projector(sky.luminance, bands, tolerance);
  std::atomic<std::size_t> evaluations = 0;
  tbb::parallel_for(std::size_t{0}, key_time_h.size(), [&](std::size_t key) {
    const model::PolarMoments moments = projector.projectPolar(model::SkyInstant(sky, key_time_h[key]));
    double* out = table.number.data() + key * table.numbersOfKey();
    for (std::size_t row = 0; row < static_cast<std::size_t>(table.rows); ++row) {
      const Number3& value = row < coefficients ? moments.radiance_sh[row] : moments.horizontal_irradiance;
      for (int c = 0; c < table.channels; ++c) *out++ = value[c];
    }
    evaluations += moments.evaluations;
    progress.step();
  });
  table.evaluations = evaluations;
  return table;
}

}  // namespace welkin::table
