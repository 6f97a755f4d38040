// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy.h"

#include <fmt/format.h>

#include <algorithm>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

constexpr std::size_t kModeCounts[] = {4, 5, 6, 8};
constexpr int kBandCounts[] = {2, 3, 5};

ModelRow measureModel(const std::string& name, const model::Sky& sky, bool grey, double step_h,
                      const base::Progress& progress) {
  ModelRow row{name, grey};
  const StudyDay day(sky, step_h, progress);
  for (std::size_t b = 0; b < std::size(kBandCounts); ++b) {
    row.bands[b] = bandsCandidate(day, kBandCounts[b], Fit::projected).error;
    row.fitted_bands[b] = bandsCandidate(day, kBandCounts[b], Fit::fitted).error;
  }
  const table::DayModes modes(day.fields(), day.grid());
  for (std::size_t k = 0; k < std::size(kModeCounts); ++k)  // a plain sky has fewer modes, and all of them serve
    row.modes[k] = modesCandidate(day, modeWeights(day, modes, kModeCounts[k]), kLargestMap, Fit::fitted).error;
  for (std::size_t b = 0; b < std::size(kBudgets); ++b) {
    table::PlanRequest request;
    request.max_error = kBudgets[b];
    const table::DayPlan plan = table::planDay(day.values(), request);
    if (!plan.met) continue;
    row.bytes[b] = plan.bytes;
    row.keys[b] = plan.table.key_time_h.size();
  }
  return row;
}

/// The worst of a number over the rows in colours.
const ModelRow& worstOf(const std::vector<ModelRow>& rows, std::size_t modes) {
  return *std::max_element(rows.begin(), rows.end(), [&](const ModelRow& a, const ModelRow& b) {
    return (a.grey ? 0.0 : a.modes[modes]) < (b.grey ? 0.0 : b.modes[modes]);
  });
}

std::string errorsTable(const std::vector<ModelRow>& rows, bool grey) {
  std::vector<TableColumn> columns = {{"model"}};
  for (const int bands : kBandCounts) columns.push_back({fmt::format("{} bands", bands), "", Quantity::share});
  for (const int bands : kBandCounts) columns.push_back({fmt::format("{} fitted", bands), "", Quantity::share});
  for (const auto modes : kModeCounts) columns.push_back({fmt::format("{} modes", modes), "", Quantity::share});
  Table table(columns);
  for (const ModelRow& row : rows) {
    if (row.grey != grey) continue;
    std::vector<Cell> cells = {row.model};
    for (const double error : row.bands) cells.emplace_back(error);
    for (const double error : row.fitted_bands) cells.emplace_back(error);
    for (const double error : row.modes) cells.emplace_back(error);
    table.addRow(std::move(cells));
  }
  return table.markdown(2);
}

std::string budgetsTable(const std::vector<ModelRow>& rows) {
  std::vector<TableColumn> columns = {{"model"}, {"colours"}};
  for (const double budget : kBudgets) {
    columns.push_back({fmt::format("bytes at {}", share(budget)), "", Quantity::bytes});
    columns.push_back({fmt::format("keys at {}", share(budget))});
  }
  Table table(columns);
  for (const ModelRow& row : rows) {
    std::vector<Cell> cells = {row.model, std::string(row.grey ? "grey" : "gradients")};
    for (std::size_t b = 0; b < std::size(kBudgets); ++b)
      for (const std::size_t count : {row.bytes[b], row.keys[b]})
        count > 0 ? cells.emplace_back(static_cast<double>(count)) : cells.emplace_back();
    table.addRow(std::move(cells));
  }
  return table.markdown(3);
}

std::string islandTable(const Study& study) {
  Table table({{"budget", "", Quantity::share},
               {"representation"},
               {"encoding"},
               {"keys"},
               {"bytes", "", Quantity::bytes},
               {"predicted error", "", Quantity::share}});
  for (const BudgetRow& row : study.tables.budgets)
    table.addRow({row.max_error, row.plan.met ? row.plan.representation.name() : "cannot be met",
                  std::string(nameOf(row.plan.encoding)), static_cast<double>(row.plan.table.key_time_h.size()),
                  static_cast<double>(row.plan.bytes), row.plan.predicted_error});
  return table.markdown(3);
}

/// How often a bake of the example takes modes, and the cost of a pixel.
std::string modesAdvice(const Study& study) {
  std::size_t modes = 0;
  for (const BudgetRow& row : study.tables.budgets)
    if (row.plan.met && row.plan.representation.modes) ++modes;
  std::string text =
      fmt::format("For the island they take the fewest bytes at {} of {} budgets.", modes, study.tables.budgets.size());
  for (const auto& [name, cost] : study.shaders)
    if (name == "irradiance 3 bands" || name == "irradiance 8 modes")
      text += fmt::format(" A pixel takes {} scalar operations, {} fetches and {} uniform loads with {}.",
                          cost.scalar_operations, cost.texture_fetches, cost.uniform_loads, name.substr(11));
  return text;
}

std::string aim(const std::vector<ModelRow>& models) {
  std::string text =
      "The aim was a worst error under 1 % with at most 8 floats a channel and instant, over all models "
      "with colours. The largest errors are";
  for (std::size_t k = 0; k < std::size(kModeCounts); ++k) {
    const ModelRow& worst = worstOf(models, k);
    text += fmt::format("{} {} with {}{} ({})",
                        k == 0                            ? ""
                        : k + 1 == std::size(kModeCounts) ? " and"
                                                          : ",",
                        share(worst.modes[k]), kModeCounts[k], k == 0 ? " modes" : "", worst.model);
  }
  const ModelRow& worst = worstOf(models, std::size(kModeCounts) - 1);
  text += worst.modes[std::size(kModeCounts) - 1] < 0.01
              ? ". The modes of a day of one sky meet the aim."
              : fmt::format(". The aim is missed: {} is the limit of 8.", worst.model);
  std::size_t count = 0;
  std::size_t met = 0;
  for (const ModelRow& row : models)
    if (!row.grey) ++count, met += row.modes[0] < 0.01 ? 1 : 0;
  return text + fmt::format(" One fetch of 4 modes keeps 1 % for {} of {} models.", met, count);
}

}  // namespace

model::Sky modelSky(const model::LuminanceModel& model, const model::Sky& example, bool grey) {
  model::Sky sky;
  sky.luminance = model;
  if (!grey) {
    sky.gradient_sun = example.gradient_sun;
    sky.gradient_anti = example.gradient_anti;
  }
  sky.sun.path.key_time_h = {4.4, 5.4, 12.0, 18.6, 19.6};  // in step with the gradients' dawn and dusk
  for (const double elevation : {-18.0, 0.0, 90.0, 0.0, -18.0}) {
    sky.sun.path.key_azimuth_rad.push_back(90.0 * det::kDegree);
    sky.sun.path.key_elevation_rad.push_back(elevation * det::kDegree);
  }
  return sky;
}

std::vector<ModelRow> measureModels(const model::Sky& example, double step_h, const StudyOptions& options) {
  std::vector<ModelRow> rows;
  for (const bool grey : {false, true})
    for (const auto& [name, model] : model::namedLuminances()) {
      rows.push_back(measureModel(std::string(name), modelSky(model, example, grey), grey, step_h,
                                  options.progress.stage("day", 0)));
      options.progress.step();
    }
  return rows;
}

std::string accuracyPage(const std::vector<ModelRow>& models, const Study& example, double step_h,
                         const std::string& command) {
  std::string page = fmt::format(
      "# Accuracy\n\nThis page compares the representations that a bake can choose, by cost and error. Written by\n\n"
      "    {}\n\n"
      "It holds no times, so it is the same on every machine. Errors are irradiance errors as docs/conventions.md "
      "defines them: the largest over normals, channels and instants, as a share of the mean irradiance. `welkin study "
      "FILE.toml -o DIR` makes the same study of any sky, with times, charts and all figures.\n\n",
      command);
  page +=
      "## What to choose\n\n"
      "- State a budget and leave the rest open: `welkin bake --max-error 0.01`, or `--quality final`. The planner "
      "weighs everything on this page, and the certificate measures the result.\n"
      "- Take modes where the light on surfaces counts. " +
      modesAdvice(example) +
      "\n"
      "- Take 3 bands, fitted, where a consumer wants SH and nothing else. They err by a third less than projected "
      "ones, "
      "at the same cost.\n"
      "- Take fixed16 numbers: they are as small as halfs and more exact, since every row has its own scale. From 3 % "
      "on, "
      "fixed8 is enough.\n"
      "- Take the analytic dome, without cubemaps, wherever nothing has to be mirrored.\n"
      "- Take no windows, unless negative light cannot be borne: they cost more than they save.\n\n";
  page += "## Every model at exact keys\n\n" + aim(models) +
          fmt::format(
              " The sun climbs from -18 degrees to the zenith and sinks again. The study samples this day every {:.3g} "
              "minutes. Modes are those of the day, fitted, in a map of {} x {}.\n\n",
              step_h * 60.0, kLargestMap.columns, kLargestMap.rows);
  page +=
      "In the colours of examples/island:\n\n" + errorsTable(models, false) + "\nGrey:\n\n" + errorsTable(models, true);
  page +=
      "\n## Every model under a budget\n\nThe smallest table, modes included, that a plan finds at these instants. A "
      "bake "
      "samples more finely, every 2.5 minutes or less, and takes more keys: compare the island. An empty cell is a "
      "budget that cannot be met.\n\n" +
      budgetsTable(models);
  page += "\n## The island\n\n" + islandTable(example) + "\n";
  for (const std::string& paragraph : conclusionOf(example)) page += paragraph + "\n\n";
  page +=
      "## Approximations\n\nEach row gives the domain, the largest error, the cost, the slow reference of the "
      "measurement and the test that sweeps the domain. \"Here\" is examples/island.\n\n" +
      approximationsTable(example);
  return page;
}

}  // namespace welkin::study
