// SPDX-License-Identifier: Apache-2.0
#include "study/measure_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "sky/table/key_placement.h"
#include "study/cubic_time.h"

namespace welkin::study {
namespace {

/// Whether keys are compared for a candidate: the best of the common ones are.
bool isCompared(const Candidate& candidate) {
  if (candidate.fit == Fit::windowed) return false;
  if (!candidate.isModes()) return candidate.fit == Fit::projected;
  return candidate.fit == Fit::projected && candidate.numbers() % 4 == 0 &&
         candidate.representation.modes->columns == kLargestMap.columns;
}

}  // namespace

KeyStudy measureKeys(const StudyDay& day, const std::vector<Candidate>& candidates, const StudyOptions& options) {
  KeyStudy study;
  for (const Candidate& candidate : candidates) {
    if (!isCompared(candidate)) continue;
    for (const std::size_t keys : {12, 24, 48, 72, 96, 144, 192, 288, 576}) {
      if (2 * keys > day.count()) break;  // no instant between them would be looked at
      const auto even = evenKeys(day, keys);
      study.even.push_back({candidate.name, even.size(), linearError(day.values(), candidate.representation, even),
                            catmullRomError(day.values(), candidate.representation, even)});
    }
    for (const double error : {0.5, 0.3, 0.2, 0.1, 0.05, 0.03, 0.02, 0.01, 0.005, 0.003}) {
      if (options.quick && error < 0.01) break;
      const auto placed = table::placeKeys(day.values(), candidate.representation, error);
      if (placed.empty()) break;
      study.counts.push_back(
          {candidate.name, error, placed.size(),
           std::max<std::size_t>(1, placeHermiteKeys(day.values(), candidate.representation, error).size()),
           catmullRomError(day.values(), candidate.representation, placed)});
    }
    options.progress.check();
  }
  return study;
}

void reportKeys(const KeyStudy& keys, StudyReport& report) {
  Table even({{"representation"},
              {"keys"},
              {"linear", "largest error", Quantity::share},
              {"catmull_rom", "largest error", Quantity::share}});
  Table placed({{"representation"},
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
  const auto isDrawn = [](const std::string& candidate) {
    return candidate == "3 bands" || candidate == "5 bands" || candidate.starts_with("8 modes");
  };
  for (const EvenKeys& row : keys.even) {
    even.addRow({row.representation, static_cast<double>(row.keys), row.linear, row.catmull_rom});
    if (isDrawn(row.representation)) add(row.representation + ", even", static_cast<double>(row.keys), row.linear);
  }
  for (const EvenKeys& row : keys.even)
    if (row.representation.starts_with("8 modes"))
      add(row.representation + ", even, cubic", static_cast<double>(row.keys), row.catmull_rom);
  for (const KeyCounts& row : keys.counts) {
    placed.addRow({row.representation, row.max_error, static_cast<double>(row.placed), static_cast<double>(row.hermite),
                   row.catmull_rom});
    if (isDrawn(row.representation))
      add(row.representation + ", placed", static_cast<double>(row.placed), row.max_error);
  }
  chart.lines = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}};
  report.tables.push_back({"keys_even", "Even keys: linear against Catmull-Rom", std::move(even)});
  report.tables.push_back({"keys_placed", "Placed keys: linear, and the most favourable cubic", std::move(placed)});
  if (!chart.series.empty()) report.charts.push_back({"keys", std::move(chart)});
}

}  // namespace welkin::study
