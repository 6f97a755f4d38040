// SPDX-License-Identifier: Apache-2.0
#include "study/measure_cubemaps.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sky/cubemap/cubemap_times.h"
#include "sky/cubemap/dome_error.h"

namespace welkin::study {
namespace {

using format::CubemapFormat;

constexpr CubemapFormat kFormats[] = {CubemapFormat::rgba16f, CubemapFormat::rgb9e5, CubemapFormat::b10g11r11};

}  // namespace

double CubemapSizeRow::error() const {
  return std::sqrt(resolution * resolution + encoding * encoding);
}

CubemapStudy measureCubemapAxis(const model::Sky& sky, const StudyOptions& options) {
  CubemapStudy study;
  const base::Progress within = options.progress.stage("cubemaps", 0);
  // Weighed by the light of the day: the horizon cuts a low sun's halo.
  const std::vector<double> hours = {0.0, 5.0, 5.5, 6.0, 7.0, 9.0, 12.0, 15.0, 17.0, 18.0, 18.5, 19.0};
  for (int size = 16; size <= (options.quick ? 64 : 256); size *= 2)
    for (const CubemapFormat format : kFormats) {
      CubemapSizeRow row{size, format,
                         static_cast<double>(format::bytesOfCubemaps(format, static_cast<std::uint64_t>(size)))};
      for (const auto& parts : cubemap::partsAt(sky, {size, format, hours, {}}, within)) {
        row.resolution = std::max(row.resolution, parts.resolution);
        row.encoding = std::max(row.encoding, parts.encoding);
      }
      study.sizes.push_back(row);
    }
  const cubemap::DomeDay day(sky, within);
  for (const double error : {0.3, 0.2, 0.1, 0.05, 0.03, 0.02, 0.01}) {
    if (options.quick && error < 0.03) break;
    const std::vector<double> tolerance(day.time_h().size(), error);
    study.times.push_back({error, day.placeQuickly(tolerance, day.time_h().size()).size()});
  }
  for (const double budget : {0.1, 0.03, 0.01}) {
    if (options.quick && budget < 0.1) break;
    const auto start = std::chrono::steady_clock::now();
    CubemapBudgetRow row{budget, cubemap::planCubemaps(sky, budget, {}, within)};
    row.plan_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    study.budgets.push_back(std::move(row));
  }
  const double texels = static_cast<double>(sky.gradient_sun.rgb.size() + sky.gradient_anti.rgb.size()) / 3.0;
  study.dome = {{model::GradientFormat::rgb32f, 12.0 * texels, 0.0},
                {model::GradientFormat::rgb9e5, 4.0 * texels,
                 cubemap::measureGradients(sky, model::GradientFormat::rgb9e5, cubemap::Effort::fast).error}};
  return study;
}

void reportCubemaps(const CubemapStudy& study, StudyReport& report) {
  Table sizes({{"size", "texels of an edge"},
               {"format"},
               {"bytes", "bytes of one", Quantity::bytes},
               {"resolution", "of the mean radiance", Quantity::share},
               {"encoding", "of the mean radiance", Quantity::share},
               {"error", "of the mean radiance", Quantity::share}});
  Chart chart{"Bytes of one cubemap against its error at its own time",
              {"bytes of one", Quantity::bytes, Scale::log},
              {"error of the radiance, root mean square", Quantity::share, Scale::log},
              {}};
  for (const CubemapFormat format : kFormats) {
    Series series{format::nameOf(format), SeriesStyle::line, {}};
    for (const CubemapSizeRow& row : study.sizes) {
      if (row.format != format) continue;
      series.points.push_back(
          {row.bytes, row.error(), format == CubemapFormat::rgba16f ? std::to_string(row.size) : ""});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  for (const CubemapSizeRow& row : study.sizes)
    sizes.addRow({static_cast<double>(row.size), std::string(format::nameOf(row.format)), row.bytes, row.resolution,
                  row.encoding, row.error()});
  chart.lines = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}};
  Table times({{"max_error", "of the mean radiance", Quantity::share}, {"times"}});
  Chart times_chart{"Cubemaps over the day against the error of blending them",
                    {"cubemaps", Quantity::number, Scale::log},
                    {"error of the radiance, root mean square", Quantity::share, Scale::log},
                    {}};
  Series blended{"the model itself, blended", SeriesStyle::line, {}};
  for (const CubemapTimesRow& row : study.times) {
    times.addRow({row.max_error, static_cast<double>(row.times)});
    blended.points.push_back({static_cast<double>(row.times), row.max_error});
  }
  times_chart.series.push_back(std::move(blended));
  Table budgets({{"max_error", "of the mean radiance", Quantity::share},
                 {"met"},
                 {"size", "texels of an edge"},
                 {"format"},
                 {"times"},
                 {"bytes", "bytes", Quantity::bytes},
                 {"measured_error", "of the mean radiance", Quantity::share},
                 {"plan_time", "seconds", Quantity::seconds}});
  Series plans{"planned by a bake", SeriesStyle::markers, {}};
  for (const CubemapBudgetRow& row : study.budgets) {
    const auto times_count = static_cast<double>(row.plan.time_h.size());
    budgets.addRow({row.max_error, std::string(row.plan.met ? "yes" : "no"), static_cast<double>(row.plan.size),
                    std::string(format::nameOf(row.plan.format)), times_count, row.plan.bytes, row.plan.measured.error,
                    row.plan_s});
    if (row.plan.measured.error > 0.0) plans.points.push_back({times_count, row.plan.measured.error});
  }
  if (!plans.points.empty()) times_chart.series.push_back(std::move(plans));
  Table dome({{"gradients"}, {"bytes", "bytes", Quantity::bytes}, {"error", "of the mean radiance", Quantity::share}});
  for (const DomeRow& row : study.dome) dome.addRow({std::string(nameOf(row.format)), row.bytes, row.error});
  report.tables.push_back({"cubemaps", "Cubemaps at their own times", std::move(sizes)});
  report.tables.push_back({"cubemap_times", "Times of cubemaps", std::move(times)});
  report.tables.push_back({"cubemap_budgets", "The plan of a bake for cubemaps", std::move(budgets)});
  report.tables.push_back({"dome", "The analytic dome: no cubemaps", std::move(dome)});
  report.charts.push_back({"cubemaps", std::move(chart)});
  report.charts.push_back({"cubemap_times", std::move(times_chart)});
}

}  // namespace welkin::study
