// SPDX-License-Identifier: Apache-2.0
#include "study/measure_representations.h"

#include <fmt/format.h>

#include <algorithm>

namespace welkin::study {
namespace {

constexpr std::size_t kKeysOfSpeed = 96;  // a search over so many keys, about as many as bakes have

const char* nameOf(Fit fit) {
  switch (fit) {
    case Fit::projected:
      return "projected";
    case Fit::fitted:
      return "fitted";
    case Fit::windowed:
      return "mildest window";
  }
  return "";
}

Chart representationsChart(const std::vector<Candidate>& candidates) {
  Chart chart{"Error at exact keys against numbers a channel and instant",
              {"numbers a channel and instant", Quantity::number, Scale::linear, Range{0.0, 12.0}},
              {"largest error of the irradiance", Quantity::share, Scale::log},
              {}};
  std::vector<std::pair<std::string, SeriesStyle>> names = {{"bands, projected", SeriesStyle::line},
                                                            {"bands, fitted", SeriesStyle::line},
                                                            {"bands, mildest window", SeriesStyle::line}};
  for (const Candidate& candidate : candidates) {
    std::string name = fmt::format("bands, {}", nameOf(candidate.fit));
    if (candidate.isModes()) {
      const auto& map = *candidate.representation.modes;
      name = fmt::format("modes, map {} x {}{}", map.columns, map.rows, candidate.fit == Fit::fitted ? ", fitted" : "");
    }
    auto found =
        std::find_if(chart.series.begin(), chart.series.end(), [&](const Series& s) { return s.name == name; });
    if (found == chart.series.end())
      found = chart.series.insert(chart.series.end(), Series{name, SeriesStyle::line, {}});
    found->points.push_back({static_cast<double>(candidate.numbers()), candidate.error});
  }
  chart.lines = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}, {0.003, "0.3 %"}};
  return chart;
}

Chart shadersChart(const std::vector<Candidate>& candidates, const std::vector<NamedShaderCost>& shaders) {
  Chart chart{"Cost of a pixel's irradiance against its error at exact keys",
              {"scalar operations of the shader", Quantity::number, Scale::linear, Range{0.0, 100.0}},
              {"largest error of the irradiance", Quantity::share, Scale::log},
              {}};
  Series bands{"bands, projected: no fetch", SeriesStyle::line, {}};
  Series fitted{"bands, fitted: no fetch", SeriesStyle::line, {}};
  Series modes{"modes: 1 fetch for 4, 2 for 8", SeriesStyle::markers, {}};
  for (const Candidate& candidate : candidates) {
    const auto cost = shaderOf(candidate, shaders);
    if (!cost || candidate.fit == Fit::windowed) continue;
    const bool is_fitted = candidate.fit == Fit::fitted;
    if (candidate.isModes() && (is_fitted || (candidate.numbers() != 4 && candidate.numbers() != 8))) continue;
    if (candidate.isModes() && candidate.representation.modes->columns < kLargestMap.columns) continue;
    auto& points = candidate.isModes() ? modes.points : is_fitted ? fitted.points : bands.points;
    const std::string label = candidate.isModes() ? fmt::format("{} modes", candidate.numbers())
                                                  : fmt::format("{} bands", candidate.representation.bands);
    points.push_back({static_cast<double>(cost->scalar_operations), candidate.error, is_fitted ? "" : label});
  }
  for (Series* series : {&bands, &fitted, &modes})
    if (!series->points.empty()) chart.series.push_back(*series);
  chart.lines = {{0.01, "1 %"}};
  return chart;
}

}  // namespace

std::vector<Candidate> collectCandidates(const StudyDay& day, const StudyOptions& options) {
  std::vector<Candidate> candidates;
  for (const int bands : {2, 3, 5})
    for (const Fit fit : {Fit::projected, Fit::fitted, Fit::windowed})
      if (options.sh_bands == 0 || bands <= options.sh_bands) candidates.push_back(bandsCandidate(day, bands, fit));
  if (options.sh_bands > 0) return candidates;
  const table::DayModes modes(day.fields(), day.grid());
  std::vector<MapSize> maps = {kSmallMap, kMiddleMap, kLargeMap, kLargestMap};
  if (options.quick) maps = {kSmallMap, kLargestMap};
  for (std::size_t count = 1; count <= (options.quick ? 8 : table::DayModes::kMost); ++count) {
    const DayWeights weights = modeWeights(day, modes, count);
    if (weights.set.count() < count) break;  // the day has no more
    for (const MapSize map : maps) candidates.push_back(modesCandidate(day, weights, map, Fit::projected));
    if ((count >= 4 && count <= 8) || count == table::DayModes::kMost)
      candidates.push_back(modesCandidate(day, weights, kLargestMap, Fit::fitted));
    options.progress.check();
  }
  return candidates;
}

std::optional<ShaderCost> shaderOf(const Candidate& candidate, const std::vector<NamedShaderCost>& shaders) {
  const std::string name = candidate.isModes() ? fmt::format("irradiance {} modes", candidate.numbers() <= 4 ? 4 : 8)
                                               : fmt::format("irradiance {} bands", candidate.representation.bands);
  if (candidate.isModes() && candidate.numbers() > 8) return std::nullopt;
  for (const NamedShaderCost& shader : shaders)
    if (shader.name == name) return shader.cost;
  return std::nullopt;
}

void reportRepresentations(const bake::SkyFile& file, const StudyDay& day, const std::vector<Candidate>& candidates,
                           StudyReport& report) {
  Table table({{"representation"},
               {"error", "of the mean irradiance", Quantity::share},
               {"window_strength"},
               {"numbers", "a channel and instant"},
               {"key_bytes", "bytes, float32", Quantity::bytes},
               {"fixed_bytes", "bytes", Quantity::bytes},
               {"instructions", "SPIR-V"},
               {"scalar_operations"},
               {"texture_fetches"},
               {"uniform_loads"},
               {"sample_time", "seconds", Quantity::seconds},
               {"irradiance_time", "seconds", Quantity::seconds}});
  const auto shaders = measuredShaders();
  for (const Candidate& candidate : candidates) {
    const auto cost = shaderOf(candidate, shaders);
    const auto counted = [&](int ShaderCost::*part) { return cost ? Cell(double{1.0} * ((*cost).*part)) : Cell(); };
    const RuntimeSpeed speed = measureRuntime(file, day, candidate, kKeysOfSpeed);
    table.addRow({candidate.name, candidate.error,
                  candidate.fit == Fit::windowed ? Cell(candidate.window_strength) : Cell(),
                  static_cast<double>(candidate.numbers()),
                  static_cast<double>(candidate.bytesOfKey(day.sky(), table::Encoding::float32)),
                  static_cast<double>(candidate.representation.fixedBytes()), counted(&ShaderCost::instructions),
                  counted(&ShaderCost::scalar_operations), counted(&ShaderCost::texture_fetches),
                  counted(&ShaderCost::uniform_loads), speed.sample_ns * 1e-9, speed.irradiance_ns * 1e-9});
  }
  report.tables.push_back({"representations", "Representations of an instant", std::move(table)});
  report.charts.push_back({"representations", representationsChart(candidates)});
  report.charts.push_back({"shaders", shadersChart(candidates, shaders)});
}

}  // namespace welkin::study
