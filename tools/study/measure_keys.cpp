// SPDX-License-Identifier: Apache-2.0
#include "study/measure_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "sky/table/key_placement.h"
#include "study/cubic_time.h"

namespace welkin::study {
namespace {

/// What is looked at closely: the best of the common ways.
bool isLookedAt(const Way& way) {
  if (way.fit == Fit::windowed) return false;
  if (!way.isModes()) return way.fit == Fit::projected;
  return way.fit == Fit::projected && way.numbers() % 4 == 0 &&
         way.representation.modes->columns == kLargestMap.columns;
}

}  // namespace

KeyStudy measureKeys(const StudyDay& day, const std::vector<Way>& ways, const StudyOptions& options) {
  KeyStudy study;
  for (const Way& way : ways) {
    if (!isLookedAt(way)) continue;
    for (const std::size_t keys : {12, 24, 48, 72, 96, 144, 192, 288, 576}) {
      if (2 * keys > day.count()) break;  // no instant between them would be looked at
      const auto even = evenKeys(day, keys);
      study.even.push_back({way.name, even.size(), linearError(day.values(), way.representation, even),
                            catmullRomError(day.values(), way.representation, even)});
    }
    for (const double error : {0.5, 0.3, 0.2, 0.1, 0.05, 0.03, 0.02, 0.01, 0.005, 0.003}) {
      if (options.quick && error < 0.01) break;
      const auto placed = table::placeKeys(day.values(), way.representation, error);
      if (placed.empty()) break;
      study.counts.push_back(
          {way.name, error, placed.size(),
           std::max<std::size_t>(1, placeHermiteKeys(day.values(), way.representation, error).size()),
           catmullRomError(day.values(), way.representation, placed)});
    }
    if (options.interrupt && !options.interrupt()) break;
  }
  return study;
}

void reportKeys(const KeyStudy& keys, StudyReport& report) {
  Table even({{"way"},
              {"keys"},
              {"linear", "largest error", Quantity::share},
              {"catmull_rom", "largest error", Quantity::share}});
  Table placed({{"way"},
                {"max_error", "of the mean irradiance", Quantity::share},
                {"linear_keys"},
                {"hermite_keys"},
                {"catmull_rom", "largest error at the linear keys", Quantity::share}});
  Chart chart{"Keys over the day against error",
              {"keys", Quantity::number, Scale::log},
              {"largest error of the irradiance", Quantity::share, Scale::log},
              {}};
  const auto add = [&](const std::string& name, double x, double y) {
    auto found =
        std::find_if(chart.series.begin(), chart.series.end(), [&](const Series& s) { return s.name == name; });
    if (found == chart.series.end())
      found = chart.series.insert(chart.series.end(), Series{name, SeriesStyle::line, {}});
    found->points.push_back({x, y});
  };
  const auto isDrawn = [](const std::string& way) {
    return way == "3 bands" || way == "5 bands" || way.starts_with("8 modes");
  };
  for (const EvenKeys& row : keys.even) {
    even.addRow({row.way, static_cast<double>(row.keys), row.linear, row.catmull_rom});
    if (isDrawn(row.way)) add(row.way + ", even", static_cast<double>(row.keys), row.linear);
  }
  for (const EvenKeys& row : keys.even)
    if (row.way.starts_with("8 modes")) add(row.way + ", even, cubic", static_cast<double>(row.keys), row.catmull_rom);
  for (const KeyCounts& row : keys.counts) {
    placed.addRow(
        {row.way, row.max_error, static_cast<double>(row.placed), static_cast<double>(row.hermite), row.catmull_rom});
    if (isDrawn(row.way)) add(row.way + ", placed", static_cast<double>(row.placed), row.max_error);
  }
  chart.levels = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}};
  report.tables.push_back({"keys_even", "Even keys: linear against Catmull-Rom", std::move(even)});
  report.tables.push_back({"keys_placed", "Placed keys: linear, and the most favourable cubic", std::move(placed)});
  if (!chart.series.empty()) report.charts.push_back({"keys", std::move(chart)});
}

}  // namespace welkin::study
