// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy.h"

#include <fmt/format.h>

#include <algorithm>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

constexpr std::size_t kModeCounts[] = {4, 5, 6, 8};
constexpr int kBandCounts[] = {2, 3, 5};

std::string share(double value) {
  return inWords(value, Quantity::share, 2);
}

ModelRow measureModel(const std::string& name, const model::Sky& sky, bool grey, double step_h,
                      const table::Progress& interrupt) {
  ModelRow row{name, grey};
  const StudyDay day(sky, step_h, interrupt);
  for (std::size_t b = 0; b < std::size(kBandCounts); ++b) {
    row.bands[b] = coefficientsWay(day, kBandCounts[b], Fit::projected).error;
    row.fitted_bands[b] = coefficientsWay(day, kBandCounts[b], Fit::fitted).error;
  }
  const table::DayModes modes(day.fields(), day.grid());
  for (std::size_t k = 0; k < std::size(kModeCounts); ++k)  // a plain sky has fewer modes, and all of them serve
    row.modes[k] = modesWay(day, modeWeights(day, modes, kModeCounts[k]), kLargestMap, Fit::fitted).error;
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
  std::vector<Column> columns = {{"model"}};
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
  std::vector<Column> columns = {{"model"}, {"colours"}};
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
               {"way"},
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

/// Largest of a number over rows that are wanted.
template <typename Rows, typename Wanted, typename Number>
double largest(const Rows& rows, const Wanted& wanted, const Number& number) {
  double most = 0.0;
  for (const auto& row : rows)
    if (wanted(row)) most = std::max(most, number(row));
  return most;
}

std::string approximations(const Study& study) {
  Table table({{"approximation"}, {"domain"}, {"largest error"}, {"cost"}, {"slow reference"}, {"test"}});
  const auto add = [&](std::vector<Cell> cells) { table.addRow(std::move(cells)); };
  const auto encoding = [&](table::Encoding e) {
    return largest(
        study.tables.encodings, [&](const EncodingRow& r) { return r.encoding == e; },
        [](const EncodingRow& r) { return r.encoding_error; });
  };
  const auto format = [&](format::CubemapFormat f) {
    return largest(
        study.cubemaps.sizes, [&](const CubemapSizeRow& r) { return r.format == f; },
        [](const CubemapSizeRow& r) { return r.encoding; });
  };
  add({"exp(d theta) of the indicatrix from a table (IndicatrixTable)", "-16 <= d < 0, theta in [0, pi]",
       fmt::format("{:.0e}, absolute", model::IndicatrixTable::kError), "half of exp and atan",
       "det::exp(d det::angleBetween)", "tests/sky/luminance_test.cpp"});
  for (const QuadratureRow& row : study.quadrature.quadrature)
    if (row.tolerance > 1e-12)
      add({fmt::format("SH coefficients under a tolerance of {:.0e} (SkyProjector)", row.tolerance),
           "every model and sun elevation", fmt::format("{:.0e} of c0 promised, {:.0e} here", row.tolerance, row.error),
           fmt::format("{:.0f} evaluations a key", row.evaluations), "the quadrature under 1e-12",
           "tests/sky/projection_test.cpp"});
  if (!study.quadrature.irradiance.empty())
    add({"irradiance of every normal from circles (IrradianceProjector)", "every named model and sun elevation",
         fmt::format("{} of the mean promised, {} here", share(model::IrradianceProjector::kError),
                     share(study.quadrature.irradiance.front().error)),
         "one quadrature for all normals", "SkyProjector::irradiance, one integral a normal",
         "tests/sky/irradiance_test.cpp"});
  for (std::size_t i = 1; i < std::size(model::kIrradianceRules); ++i)
    add({fmt::format("the same in {} panels of elevation, where a plan's budget allows it",
                     model::kIrradianceRules[i].panels),
         "every named model and sun elevation",
         fmt::format("{} of the mean promised", share(model::kIrradianceRules[i].error)),
         fmt::format("down from {} panels", model::kIrradianceRules[0].panels), "48 panels",
         "tests/sky/irradiance_test.cpp"});
  for (const auto& [e, bound, bytes] : {std::tuple(table::Encoding::float32, "2^-24 of a number", 4),
                                        {table::Encoding::float16, "2^-11 of a number, 2^-25 of its key's largest", 2},
                                        {table::Encoding::fixed16, "1/65534 of key's times row's largest", 2},
                                        {table::Encoding::fixed8, "1/254 of key's times row's largest", 1}})
    add({fmt::format("numbers as {}", nameOf(e)), "finite tables",
         fmt::format("{}; {} of the irradiance here", bound, share(encoding(e))),
         fmt::format("{} {} a number", bytes, bytes == 1 ? "byte" : "bytes"), "the numbers in double",
         "tests/runtime/day_table_test.cpp"});
  for (const MapSize map : {kSmallMap, kMiddleMap, kLargeMap, kLargestMap})
    for (const Way& way : study.ways)
      if (way.isModes() && way.numbers() == 8 && way.fit == Fit::projected &&
          way.representation.modes->columns == map.columns && way.representation.modes->rows == map.rows)
        add({fmt::format("8 modes from a map of {} x {}", map.columns, map.rows), "every normal",
             fmt::format("{} with the modes left out, here", share(way.error)),
             inWords(static_cast<double>(way.representation.fixedBytes()), Quantity::bytes, 3), "the modes' own series",
             "tests/runtime/modes_test.cpp"});
  for (const auto f : {format::CubemapFormat::rgba16f, format::CubemapFormat::rgb9e5, format::CubemapFormat::b10g11r11})
    add({fmt::format("cubemaps in {}", format::nameOf(f)), "0 to the format's largest value",
         fmt::format("{} of the mean radiance here, root mean square", share(format(f))),
         fmt::format("{} bytes a texel", format::texelBytes(f)), "texels in double",
         "tests/sky/cubemap_format_test.cpp"});
  for (const DomeRow& row : study.cubemaps.dome)
    if (row.error > 0.0)
      add({fmt::format("gradients in {}", nameOf(row.format)), "every gradient",
           fmt::format("2^-9 of a texel's largest; {} of the dome here", share(row.error)), "4 bytes a texel, for 12",
           "gradients as floats", "tests/sky/dome_error_test.cpp"});
  add({"a GPU's filter of the map of modes", "subTexelPrecisionBits b, 8 on common devices",
       "2^-b of the differences to the next column and row, of each mode", "none: it is the hardware's",
       "the same product in double", "tests/runtime/modes_test.cpp"});
  return table.markdown(3);
}

/// Whether a bake of the example takes modes, and what they cost a pixel.
std::string modesAdvice(const Study& study) {
  std::size_t modes = 0;
  for (const BudgetRow& row : study.tables.budgets)
    if (row.plan.met && row.plan.representation.modes) ++modes;
  std::string text =
      fmt::format("for the island they are the least at {} of {} budgets", modes, study.tables.budgets.size());
  for (const auto& [name, cost] : study.shaders)
    if (name == "irradiance 3 bands" || name == "irradiance 8 modes")
      text += fmt::format("{} take a pixel {} scalar operations, {} fetches and {} uniform loads",
                          name == "irradiance 3 bands" ? "; 3 bands" : ", 8 modes", cost.scalar_operations,
                          cost.texture_fetches, cost.uniform_loads);
  return text + ".";
}

std::string aim(const std::vector<ModelRow>& models) {
  std::string text =
      "The aim was a worst error under 1 % with at most 8 floats a channel and instant, over all models "
      "with colours. In colours";
  for (std::size_t k = 0; k < std::size(kModeCounts); ++k) {
    const ModelRow& worst = worstOf(models, k);
    text += fmt::format("{} {} modes err by at most {} ({})",
                        k == 0                            ? ""
                        : k + 1 == std::size(kModeCounts) ? ", and"
                                                          : ",",
                        kModeCounts[k], share(worst.modes[k]), worst.model);
  }
  const ModelRow& worst = worstOf(models, std::size(kModeCounts) - 1);
  text += worst.modes[std::size(kModeCounts) - 1] < 0.01
              ? ": the aim is met for modes of a day of one sky."
              : fmt::format(": the aim is missed, and {} is the limit of 8.", worst.model);
  std::size_t count = 0;
  std::size_t met = 0;
  for (const ModelRow& row : models)
    if (!row.grey) ++count, met += row.modes[0] < 0.01 ? 1 : 0;
  return text + fmt::format(" 4 modes, one fetch, keep 1 % for {} of {} models.", met, count);
}

}  // namespace

model::Sky modelSky(const model::LuminanceModel& model, const model::Sky& example, bool grey) {
  model::Sky sky;
  sky.luminance = model;
  if (!grey) {
    sky.gradient_sun = example.gradient_sun;
    sky.gradient_anti = example.gradient_anti;
  }
  constexpr double kDegree = det::kHalfPi / 90.0;
  sky.sun.path.key_time_h = {4.4, 5.4, 12.0, 18.6, 19.6};  // in step with the gradients' dawn and dusk
  for (const double elevation : {-18.0, 0.0, 90.0, 0.0, -18.0}) {
    sky.sun.path.key_azimuth_rad.push_back(90.0 * kDegree);
    sky.sun.path.key_elevation_rad.push_back(elevation * kDegree);
  }
  return sky;
}

std::vector<ModelRow> measureModels(const model::Sky& example, double step_h, const StudyOptions& options) {
  std::vector<ModelRow> rows;
  for (const bool grey : {false, true})
    for (const auto& [name, model] : model::namedLuminances()) {
      const table::Progress interrupt = [&] { return !options.interrupt || options.interrupt(); };
      rows.push_back(measureModel(std::string(name), modelSky(model, example, grey), grey, step_h, interrupt));
      if (options.progress && !options.progress()) throw base::Error(base::ExitStatus::interrupted, "interrupted");
    }
  return rows;
}

std::string accuracyPage(const std::vector<ModelRow>& models, const Study& example, double step_h,
                         const std::string& command) {
  std::string page = fmt::format(
      "# Accuracy\n\nWhat the ways to bake a sky cost and lose. This page is written by\n\n    {}\n\nand holds no "
      "times: it "
      "is the same on every machine. Errors are irradiance errors as docs/conventions.md defines them: the largest "
      "over "
      "normals, channels and instants, of the mean irradiance. `welkin study FILE.toml -o DIR` makes the same study of "
      "any "
      "sky, with times, charts and all figures.\n\n",
      command);
  page +=
      "## What to choose\n\n"
      "- State a budget and leave the rest open: `welkin bake --max-error 0.01`, or `--quality final`. The planner "
      "weighs "
      "everything on this page, and the certificate measures what came of it.\n"
      "- Modes where the light on surfaces counts: " +
      modesAdvice(example) +
      "\n"
      "- 3 bands, fitted, where a consumer wants SH and nothing else: a third less error than projected, at the same "
      "cost.\n"
      "- fixed16 numbers: as small as halfs and more exact, since every row has its own scale; fixed8 from 3 % on.\n"
      "- The analytic dome, without cubemaps, wherever nothing has to be mirrored.\n"
      "- No windows: they cost more than they save, and are there only for who cannot bear negative light.\n\n";
  page += "## Every model at exact keys\n\n" + aim(models) +
          fmt::format(
              " The sun climbs from -18 degrees to the zenith and sinks again, looked at every {:.3g} minutes; modes "
              "are those of the day, fitted, in a map of {} x {}.\n\n",
              step_h * 60.0, kLargestMap.columns, kLargestMap.rows);
  page +=
      "In the colours of examples/island:\n\n" + errorsTable(models, false) + "\nGrey:\n\n" + errorsTable(models, true);
  page +=
      "\n## Every model under a budget\n\nThe least table, modes included, that a plan finds at these instants. A bake "
      "looks more closely, every 2.5 minutes or less, and takes more keys: compare the island. Empty: "
      "cannot "
      "be met at them.\n\n" +
      budgetsTable(models);
  page += "\n## The island\n\n" + islandTable(example) + "\n";
  for (const std::string& paragraph : conclusionOf(example)) page += paragraph + "\n\n";
  page +=
      "## Approximations\n\nEach with its domain, its largest error, what it costs, the slow reference that it is "
      "measured against and the test that sweeps it. \"Here\": of examples/island.\n\n" +
      approximations(example);
  return page;
}

}  // namespace welkin::study
