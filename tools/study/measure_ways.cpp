// SPDX-License-Identifier: Apache-2.0
#include "study/measure_ways.h"

#include <fmt/format.h>

#include <algorithm>

namespace welkin::study {
namespace {

constexpr std::size_t kKeysOfSpeed = 96;  // a search over so many keys, about what bakes have

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

Chart waysChart(const std::vector<Way>& ways) {
  Chart chart{"What is lost at exact keys, by numbers a channel and instant",
              {"numbers a channel and instant", Quantity::number, Scale::linear, Range{0.0, 12.0}},
              {"largest error of the irradiance", Quantity::share, Scale::log},
              {}};
  std::vector<std::pair<std::string, SeriesStyle>> names = {{"bands, projected", SeriesStyle::line},
                                                            {"bands, fitted", SeriesStyle::line},
                                                            {"bands, mildest window", SeriesStyle::line}};
  for (const Way& way : ways) {
    std::string name = fmt::format("bands, {}", nameOf(way.fit));
    if (way.isModes()) {
      const auto& map = *way.representation.modes;
      name = fmt::format("modes, map {} x {}{}", map.columns, map.rows, way.fit == Fit::fitted ? ", fitted" : "");
    }
    auto found =
        std::find_if(chart.series.begin(), chart.series.end(), [&](const Series& s) { return s.name == name; });
    if (found == chart.series.end())
      found = chart.series.insert(chart.series.end(), Series{name, SeriesStyle::line, {}});
    found->points.push_back({static_cast<double>(way.numbers()), way.error});
  }
  chart.levels = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}, {0.003, "0.3 %"}};
  return chart;
}

Chart shadersChart(const std::vector<Way>& ways, const std::vector<NamedShaderCost>& shaders) {
  Chart chart{"What a pixel's irradiance costs, against its error at exact keys",
              {"scalar operations of the shader", Quantity::number, Scale::linear, Range{0.0, 100.0}},
              {"largest error of the irradiance", Quantity::share, Scale::log},
              {}};
  Series bands{"bands, projected: no fetch", SeriesStyle::line, {}};
  Series fitted{"bands, fitted: no fetch", SeriesStyle::line, {}};
  Series modes{"modes: 1 fetch for 4, 2 for 8", SeriesStyle::markers, {}};
  for (const Way& way : ways) {
    const auto cost = shaderOf(way, shaders);
    if (!cost || way.fit == Fit::windowed) continue;
    const bool is_fitted = way.fit == Fit::fitted;
    if (way.isModes() && (is_fitted || (way.numbers() != 4 && way.numbers() != 8))) continue;
    if (way.isModes() && way.representation.modes->columns < kLargestMap.columns) continue;
    auto& points = way.isModes() ? modes.points : is_fitted ? fitted.points : bands.points;
    const std::string label =
        way.isModes() ? fmt::format("{} modes", way.numbers()) : fmt::format("{} bands", way.representation.bands);
    points.push_back({static_cast<double>(cost->scalar_operations), way.error, is_fitted ? "" : label});
  }
  for (Series* series : {&bands, &fitted, &modes})
    if (!series->points.empty()) chart.series.push_back(*series);
  chart.levels = {{0.01, "1 %"}};
  return chart;
}

}  // namespace

std::vector<Way> collectWays(const StudyDay& day, const StudyOptions& options) {
  std::vector<Way> ways;
  for (const int bands : {2, 3, 5})
    for (const Fit fit : {Fit::projected, Fit::fitted, Fit::windowed}) ways.push_back(coefficientsWay(day, bands, fit));
  const table::DayModes modes(day.fields(), day.grid());
  std::vector<MapSize> maps = {kSmallMap, kMiddleMap, kLargeMap, kLargestMap};
  if (options.quick) maps = {kSmallMap, kLargestMap};
  for (std::size_t count = 1; count <= (options.quick ? 8 : table::DayModes::kMost); ++count) {
    const DayWeights weights = modeWeights(day, modes, count);
    if (weights.set.count() < count) break;  // the day has no more
    for (const MapSize map : maps) ways.push_back(modesWay(day, weights, map, Fit::projected));
    if ((count >= 4 && count <= 8) || count == table::DayModes::kMost)
      ways.push_back(modesWay(day, weights, kLargestMap, Fit::fitted));
    if (options.interrupt && !options.interrupt()) break;
  }
  return ways;
}

std::optional<ShaderCost> shaderOf(const Way& way, const std::vector<NamedShaderCost>& shaders) {
  const std::string name = way.isModes() ? fmt::format("irradiance {} modes", way.numbers() <= 4 ? 4 : 8)
                                         : fmt::format("irradiance {} bands", way.representation.bands);
  if (way.isModes() && way.numbers() > 8) return std::nullopt;
  for (const NamedShaderCost& shader : shaders)
    if (shader.name == name) return shader.cost;
  return std::nullopt;
}

void reportWays(const bake::SkyFile& file, const StudyDay& day, const std::vector<Way>& ways, StudyReport& report) {
  Table table({{"way"},
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
  for (const Way& way : ways) {
    const auto cost = shaderOf(way, shaders);
    const auto counted = [&](int ShaderCost::*part) { return cost ? Cell(double{1.0} * ((*cost).*part)) : Cell(); };
    const RuntimeSpeed speed = measureRuntime(file, day, way, kKeysOfSpeed);
    table.addRow({way.name, way.error, way.fit == Fit::windowed ? Cell(way.window_strength) : Cell(),
                  static_cast<double>(way.numbers()),
                  static_cast<double>(way.bytesOfKey(day.sky(), table::Encoding::float32)),
                  static_cast<double>(way.representation.fixedBytes()), counted(&ShaderCost::instructions),
                  counted(&ShaderCost::scalar_operations), counted(&ShaderCost::texture_fetches),
                  counted(&ShaderCost::uniform_loads), speed.sample_ns * 1e-9, speed.irradiance_ns * 1e-9});
  }
  report.tables.push_back({"ways", "Ways to hold an instant", std::move(table)});
  report.charts.push_back({"ways", waysChart(ways)});
  report.charts.push_back({"shaders", shadersChart(ways, shaders)});
}

}  // namespace welkin::study
