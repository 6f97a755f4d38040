// SPDX-License-Identifier: Apache-2.0
#include "sky/day_table.h"

#include <tbb/parallel_for.h>

#include <atomic>

#include "sh/basis.h"
#include "sky/error.h"

namespace welkin::sky {

DayTable bakeDayTable(const Sky& sky, int bands, const std::vector<double>& key_time_h, const Progress& progress,
                      double tolerance) {
  const auto count = static_cast<std::size_t>(sh::coefficientCount(bands));
  DayTable table{bands, key_time_h, std::vector<float>(key_time_h.size() * count * 3),
                 std::vector<float>(key_time_h.size() * 3), 0};
  const SkyProjector projector(sky.luminance, bands, tolerance);
  std::atomic<std::size_t> evaluations = 0;
  tbb::parallel_for(std::size_t{0}, key_time_h.size(), [&](std::size_t key) {
    const SkyMoments moments = projector.project(SkyInstant(sky, key_time_h[key]));
    for (std::size_t i = 0; i < count; ++i)
      for (int c = 0; c < 3; ++c)
        table.shape_sh[(key * count + i) * 3 + static_cast<std::size_t>(c)] =
            static_cast<float>(moments.radiance_sh[i][c]);
    for (int c = 0; c < 3; ++c)
      table.shape_irradiance[key * 3 + static_cast<std::size_t>(c)] =
          static_cast<float>(moments.horizontal_irradiance[c]);
    evaluations += moments.evaluations;
    if (!progress()) throw Error(ExitStatus::interrupted, "interrupted");
  });
  table.evaluations = evaluations;
  return table;
}

}  // namespace welkin::sky
