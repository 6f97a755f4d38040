// SPDX-License-Identifier: Apache-2.0
// The modes as a map of texels, and values read from it.
#include <Imath/half.h>

#include <algorithm>
#include <cmath>

#include "format/half.h"
#include "format/mode_texels.h"
#include "sh/multiple_cosines.h"
#include "sky/table/modes.h"

namespace welkin::table {

using det::Number3;
namespace {

constexpr std::size_t kSeriesRows = model::IrradianceProjector::kRows;
constexpr std::size_t kSeriesOrders = model::IrradianceProjector::kOrders;

/// Values of a mode at the texels' centres, by row and column.
std::vector<double> atCentres(const FieldChannel& mode, std::size_t columns, std::size_t rows) {
  std::vector<double> value;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const double* series = mode.series.data() + j * (kSeriesRows - 1) / (rows - 1) * kSeriesOrders;
      sh::MultipleCosines cosine(2.0 * static_cast<double>(i) / static_cast<double>(columns - 1) - 1.0);
      double sum = 0.0;
      for (std::size_t m = 0; m < kSeriesOrders; ++m, cosine.advance()) sum += series[m] * cosine.value();
      value.push_back(sum);
    }
  return value;
}

/// Second difference at place i of `count` numbers that are `stride` apart. At an end it is the neighbour's.
double secondDifference(const double* at, std::size_t i, std::size_t count, std::ptrdiff_t stride) {
  if (count < 3) return 0.0;
  const double* middle = at + (i == 0 ? stride : i + 1 == count ? -stride : 0);
  return middle[-stride] - 2.0 * middle[0] + middle[stride];
}

}  // namespace

ModeTable mapOf(const ModeSet& modes, int columns, int rows, int bands) {
  ModeTable map{static_cast<int>(modes.count()), columns, rows, {}, {}};
  const auto width = static_cast<std::size_t>(columns);
  const auto height = static_cast<std::size_t>(rows);
  map.texels.resize(width * height * modes.count());
  for (std::size_t k = 0; k < modes.count(); ++k) {
    const std::vector<double> value = atCentres(modes.mode[k], width, height);
    const auto rowBend = [&](std::size_t i, std::size_t j) {
      return secondDifference(value.data() + j * width + i, j, height, static_cast<std::ptrdiff_t>(width));
    };
    double zenith = 0.0;  // All columns are one normal there.
    for (std::size_t i = 0; i < width; ++i) zenith += rowBend(i, height - 1) / static_cast<double>(width);
    for (std::size_t j = 0; j < height; ++j)
      for (std::size_t i = 0; i < width; ++i) {
        const double* at = value.data() + j * width + i;
        const double bend = j + 1 == height ? zenith : secondDifference(at, i, width, 1) + rowBend(i, j);
        const double texel = *at - bend / 16.0;
        map.texels[(j * width + i) * modes.count() + k] = Imath::half(static_cast<float>(texel)).bits();
      }
    for (std::size_t i = 0; i < model::polarIndex(bands, 0); ++i)
      map.polar_sh.push_back(static_cast<float>(modes.mode[k].moment[i]));
  }
  return map;
}

std::vector<double> mapValues(const ModeTable& map, const ErrorGrid& grid) {
  const auto count = static_cast<std::size_t>(map.count);
  const auto columns = static_cast<std::size_t>(map.columns);
  const auto rows = static_cast<std::size_t>(map.rows);
  const std::size_t coefficients = map.polar_sh.size() / count;
  std::vector<double> values(grid.count() * count);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> upper;
    for (std::size_t p = 0; p < grid.count() / 2; ++p) {
      const Number3 n = grid.normal(p).inSunFrame();
      const double horizontal = det::horizontalLength(n);
      const auto texels = format::modeTexelsAt(det::modeColumn(n, horizontal, 0.0, 1.0),
                                               std::clamp(det::modeRow(horizontal, n.y), 0.0, 1.0), columns, rows);
      upper.push_back(texels.blend([&](std::size_t i, std::size_t j) {
        return double{format::floatFromHalf(map.texels[(j * columns + i) * count + k])};
      }));
    }
    const float* moment = map.polar_sh.data() + k * coefficients;
    grid.addLower(upper, double{moment[model::polarIndex(1, 0)]} / det::kShLinear,
                  double{moment[model::polarIndex(1, 1)]} / det::kShLinear);
    for (std::size_t p = 0; p < grid.count(); ++p) values[p * count + k] = upper[p];
  }
  return values;
}

}  // namespace welkin::table
