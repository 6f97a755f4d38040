// SPDX-License-Identifier: Apache-2.0
#include "study/measure_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "sky/table/key_placement.h"
#include "study/pareto.h"

namespace welkin::study {
namespace {

/// Errors that keys are placed for.
constexpr double kAims[] = {0.5, 0.3, 0.2, 0.1, 0.07, 0.05, 0.03, 0.02, 0.01, 0.007, 0.005, 0.003};

/// Aims up to this many times its own error are tried for a candidate: past it one of fewer numbers is smaller.
constexpr double kFarthest = 4.0;

}  // namespace

std::vector<EncodingRow> measureEncodings(const StudyDay& day, const std::vector<Candidate>& candidates) {
  std::vector<EncodingRow> rows;
  const auto keys = evenKeys(day, std::min<std::size_t>(288, day.count() / 2));
  for (const Candidate& candidate : candidates) {
    const bool bands = !candidate.isModes() && candidate.fit == Fit::projected;
    const bool modes = candidate.isModes() && candidate.fit == Fit::projected && candidate.numbers() % 4 == 0 &&
                       candidate.representation.modes->columns == kLargestMap.columns;
    if (!bands && !modes) continue;
    const table::DayTable table = table::tableAt(day.values(), candidate.representation, keys);
    for (const table::Encoding encoding : format::kEncodings)
      rows.push_back({candidate.name, encoding, keys.size(), table::bytesOf(candidate.representation, table, encoding),
                      table::partsOf(day.values(), candidate.representation, table, encoding).encoding,
                      table::errorOf(day.values(), candidate.representation, table, encoding).value});
  }
  return rows;
}

std::vector<MeasuredTable> measureTables(const StudyDay& day, const std::vector<Candidate>& candidates,
                                         const StudyOptions& options) {
  std::vector<MeasuredTable> tables;
  for (const Candidate& candidate : candidates) {
    for (const double aim : kAims) {
      if (candidate.error > aim || candidate.error * kFarthest < aim || candidate.fit == Fit::windowed) continue;
      const auto keys = table::placeKeys(day.values(), candidate.representation, aim);
      if (keys.empty()) continue;
      const table::DayTable table = table::tableAt(day.values(), candidate.representation, keys);
      for (const table::Encoding encoding : format::kEncodings)
        tables.push_back({fmt::format("{}, {} keys, {}", candidate.name, keys.size(), nameOf(encoding)), keys.size(),
                          table::bytesOf(candidate.representation, table, encoding),
                          table::errorOf(day.values(), candidate.representation, table, encoding).value,
                          candidate.isModes(), candidate.fit == Fit::fitted});
    }
    options.progress.check();
  }
  return tables;
}

std::vector<BudgetRow> measureBudgets(const StudyDay& day, const StudyOptions& options) {
  std::vector<BudgetRow> rows;
  for (const double budget : kBudgets) {
    if (options.quick && budget < 0.01) break;
    const auto start = std::chrono::steady_clock::now();
    table::PlanRequest request;
    request.max_error = budget;
    request.sh_bands = options.sh_bands;
    BudgetRow row{budget, table::planDay(day.values(), request), 0.0};
    row.plan_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rows.push_back(std::move(row));
    options.progress.check();
  }
  return rows;
}

void addPlans(TableStudy& study) {
  for (const auto& [budget, plan, seconds] : study.budgets) {
    const std::size_t keys = plan.table.key_time_h.size();
    if (plan.met)
      study.tables.push_back({fmt::format("{}, {} keys, {}", plan.representation.name(), keys, nameOf(plan.encoding)),
                              keys, plan.bytes, plan.predicted_error, plan.representation.modes.has_value(),
                              plan.representation.fitted});
  }
}

std::vector<std::size_t> frontOf(const std::vector<MeasuredTable>& tables) {
  std::vector<Tradeoff> tradeoffs;
  for (const MeasuredTable& table : tables) tradeoffs.push_back({static_cast<double>(table.bytes), table.error});
  return paretoFront(tradeoffs);
}

namespace {

Chart paretoChart(const TableStudy& study) {
  Chart chart{"Bytes of the day's table against its error",
              {"bytes, modes included", Quantity::bytes, Scale::log},
              {"largest error of the irradiance", Quantity::share, Scale::log},
              {}};
  Series bands{"bands, projected", SeriesStyle::markers, {}};
  Series fitted{"bands, fitted", SeriesStyle::markers, {}};
  Series modes{"modes", SeriesStyle::markers, {}};
  for (const MeasuredTable& table : study.tables) {
    auto& points = table.is_modes ? modes.points : table.is_fitted ? fitted.points : bands.points;
    points.push_back({static_cast<double>(table.bytes), table.error});
  }
  Series front{"Pareto front", SeriesStyle::front, {}};
  for (const std::size_t i : study.front)
    front.points.push_back({static_cast<double>(study.tables[i].bytes), study.tables[i].error});
  Series plans{"planned by a bake", SeriesStyle::markers, {}};
  for (const BudgetRow& row : study.budgets)
    if (row.plan.met) plans.points.push_back({static_cast<double>(row.plan.bytes), row.plan.predicted_error});
  for (Series* series : {&bands, &fitted, &modes, &front, &plans})
    if (!series->points.empty()) chart.series.push_back(std::move(*series));
  chart.lines = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}, {0.003, "0.3 %"}};
  return chart;
}

Chart encodingsChart(const std::vector<EncodingRow>& rows) {
  Chart chart{"Error that rounding the numbers adds, at even keys",
              {"bytes, modes included", Quantity::bytes, Scale::log},
              {"error of the encoding alone", Quantity::share, Scale::log},
              {}};
  for (const table::Encoding encoding : format::kEncodings) {
    Series series{nameOf(encoding), SeriesStyle::line, {}};
    for (const EncodingRow& row : rows)
      if (row.encoding == encoding)
        series.points.push_back(
            {static_cast<double>(row.bytes), row.encoding_error,
             encoding == format::kEncodings.back() ? row.representation.substr(0, row.representation.find(',')) : ""});
    chart.series.push_back(std::move(series));
  }
  chart.lines = {{0.03, "3 %"}, {0.01, "1 %"}, {0.003, "0.3 %"}};
  return chart;
}

}  // namespace

void reportTables(const TableStudy& study, StudyReport& report) {
  const std::vector<TableColumn> columns = {
      {"table"}, {"keys"}, {"bytes", "bytes", Quantity::bytes}, {"error", "of the mean irradiance", Quantity::share}};
  Table front(columns);
  Table all(columns);
  const auto add = [](Table& table, const MeasuredTable& row) {
    table.addRow({row.name, static_cast<double>(row.keys), static_cast<double>(row.bytes), row.error});
  };
  for (const MeasuredTable& row : study.tables) add(all, row);
  for (const std::size_t i : study.front) add(front, study.tables[i]);
  Table encodings({{"representation"},
                   {"encoding"},
                   {"keys"},
                   {"bytes", "bytes", Quantity::bytes},
                   {"encoding_error", "of the mean irradiance", Quantity::share},
                   {"error", "of the mean irradiance", Quantity::share}});
  for (const EncodingRow& row : study.encodings)
    encodings.addRow({row.representation, std::string(nameOf(row.encoding)), static_cast<double>(row.keys),
                      static_cast<double>(row.bytes), row.encoding_error, row.error});
  Table budgets({{"max_error", "of the mean irradiance", Quantity::share},
                 {"met"},
                 {"representation"},
                 {"encoding"},
                 {"keys"},
                 {"bytes", "bytes", Quantity::bytes},
                 {"predicted_error", "of the mean irradiance", Quantity::share},
                 {"plan_time", "seconds", Quantity::seconds}});
  for (const BudgetRow& row : study.budgets)
    budgets.addRow({row.max_error, std::string(row.plan.met ? "yes" : "no"), row.plan.representation.name(),
                    std::string(nameOf(row.plan.encoding)), static_cast<double>(row.plan.table.key_time_h.size()),
                    static_cast<double>(row.plan.bytes), row.plan.predicted_error, row.plan_s});
  report.tables.push_back({"budgets", "The plan of a bake for a budget", std::move(budgets)});
  report.tables.push_back({"pareto", "The Pareto front of bytes and error", std::move(front)});
  report.tables.push_back({"encodings", "Encodings at even keys", std::move(encodings)});
  report.tables.push_back({"tables", "All tables that were measured", std::move(all), false});
  if (!study.tables.empty()) report.charts.push_back({"pareto", paretoChart(study)});
  if (!study.encodings.empty()) report.charts.push_back({"encodings", encodingsChart(study.encodings)});
}

}  // namespace welkin::study
