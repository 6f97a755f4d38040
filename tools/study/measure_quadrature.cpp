// SPDX-License-Identifier: Apache-2.0
#include "study/measure_quadrature.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace welkin::study {
namespace {

constexpr double kTolerances[] = {1e-4, 1e-5, 1e-9, 1e-12};
constexpr double kConverged = 1e-9;  // of direct integration: 1e-12 takes seconds a normal
constexpr std::size_t kNormalsApart = 45;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// An empty cell for the reference.
Cell errorCell(double error, bool is_reference) {
  Cell cell;
  if (!is_reference) cell = error;
  return cell;
}

std::vector<model::SkyInstant> instantsOf(const model::Sky& sky, std::size_t count) {
  std::vector<model::SkyInstant> instants;
  for (std::size_t i = 0; i < count; ++i)  // none at a whole hour, where curves have keys
    instants.emplace_back(sky, format::kDay_h * (static_cast<double>(i) + 0.37) / static_cast<double>(count));
  return instants;
}

std::vector<QuadratureRow> measureProjector(const model::Sky& sky, const std::vector<model::SkyInstant>& instants) {
  std::vector<QuadratureRow> rows;
  std::vector<std::vector<model::PolarMoments>> moments;
  for (const double tolerance : kTolerances) {
    const model::SkyProjector projector(sky.luminance, model::IrradianceProjector::kBands, tolerance);
    QuadratureRow row{tolerance};
    moments.emplace_back();
    const auto start = std::chrono::steady_clock::now();
    for (const auto& instant : instants) moments.back().push_back(projector.projectPolar(instant));
    row.key_s = secondsSince(start) / static_cast<double>(instants.size());
    for (const auto& m : moments.back())
      row.evaluations += static_cast<double>(m.evaluations) / static_cast<double>(instants.size());
    rows.push_back(row);
  }
  const auto& reference = moments.back();
  for (std::size_t t = 0; t < rows.size(); ++t)
    for (std::size_t i = 0; i < reference.size(); ++i) {
      const auto& want = reference[i].radiance_sh;
      const double scale = std::max({want[0].x, want[0].y, want[0].z});
      for (std::size_t k = 0; k < want.size(); ++k)
        for (int c = 0; c < 3; ++c)
          if (scale > 0.0)
            rows[t].error = std::max(rows[t].error, std::abs(moments[t][i].radiance_sh[k][c] - want[k][c]) / scale);
    }
  return rows;
}

std::vector<IrradianceRow> measureIrradiance(const StudyDay& day, const std::vector<model::SkyInstant>& instants) {
  const model::Sky& sky = day.sky();
  const model::SkyProjector converged(sky.luminance, 1, kConverged);
  const model::SkyProjector direct(sky.luminance, 1, model::kTolerance);
  const model::IrradianceProjector projector(sky.luminance);
  IrradianceRow circles{"circles (IrradianceProjector)"};
  IrradianceRow integrated{"direct integration, 1e-5"};
  IrradianceRow reference{"direct integration, 1e-9"};
  const auto normals = static_cast<double>(day.grid().count());
  const auto share = 1.0 / static_cast<double>(instants.size());
  for (const auto& instant : instants) {
    auto start = std::chrono::steady_clock::now();
    const model::IrradianceField field = projector.fieldOf(instant);
    std::vector<double> value[3];
    for (int c = 0; c < 3; ++c) value[c] = day.grid().valuesOf(table::FieldChannel(field, c));
    circles.instant_s += secondsSince(start) * share;
    const det::Number3& sun = instant.sunDirection();
    const double length = det::horizontalLength(sun);
    const det::Number3 along = length > 0.0 ? det::Number3(sun.x / length, 0.0, sun.z / length) : det::Number3(0, 0, 1);
    double integrated_normals = 0.0;
    for (std::size_t p = 0; p < day.grid().count(); p += kNormalsApart, integrated_normals += 1.0) {
      const det::Number3 n = day.grid().normal(p).inSunFrame();
      const det::Number3 world = along * n.z + det::Number3(along.z, 0.0, -along.x) * n.x + det::Number3(0.0, n.y, 0.0);
      start = std::chrono::steady_clock::now();
      const det::Number3 want = converged.irradiance(instant, world);
      reference.instant_s += secondsSince(start) * share;
      start = std::chrono::steady_clock::now();
      const det::Number3 got = direct.irradiance(instant, world);
      integrated.instant_s += secondsSince(start) * share;
      for (int c = 0; c < 3; ++c) {
        if (!(field.mean[c] > 0.0)) continue;
        circles.error = std::max(circles.error, std::abs(value[c][p] - want[c]) / field.mean[c]);
        integrated.error = std::max(integrated.error, std::abs(got[c] - want[c]) / field.mean[c]);
      }
    }
    if (&instant == &instants.back()) {  // as if all normals had been integrated
      integrated.instant_s *= normals / integrated_normals;
      reference.instant_s *= normals / integrated_normals;
    }
  }
  return {circles, integrated, reference};
}

}  // namespace

QuadratureStudy measureQuadrature(const StudyDay& day, const StudyOptions& options) {
  const auto instants = instantsOf(day.sky(), options.quick ? 6 : 12);
  QuadratureStudy study;
  study.quadrature = measureProjector(day.sky(), instants);
  options.progress.check();
  study.irradiance = measureIrradiance(day, instants);
  return study;
}

void reportQuadrature(const QuadratureStudy& study, StudyReport& report) {
  Table quadrature(
      {{"tolerance"}, {"evaluations", "a key"}, {"error", "of c0"}, {"key_time", "seconds", Quantity::seconds}});
  Chart chart{"Evaluations of the sky a key against the error of a coefficient",
              {"evaluations of the radiance", Quantity::number, Scale::log},
              {"largest error of a coefficient, of c0", Quantity::number, Scale::log},
              {}};
  Series series{"SkyProjector, five bands", SeriesStyle::line, {}};
  for (const QuadratureRow& row : study.quadrature) {
    const bool is_reference = &row == &study.quadrature.back();
    quadrature.addRow({row.tolerance, row.evaluations, errorCell(row.error, is_reference), row.key_s});
    if (!is_reference)
      series.points.push_back({row.evaluations, row.error, inWords(row.tolerance, Quantity::number, 1)});
  }
  chart.series.push_back(std::move(series));
  Table irradiance({{"method"},
                    {"error", "of the mean irradiance", Quantity::share},
                    {"instant_time", "seconds, all normals", Quantity::seconds}});
  for (const IrradianceRow& row : study.irradiance) {
    const bool is_reference = &row == &study.irradiance.back();
    irradiance.addRow({row.method, errorCell(row.error, is_reference), row.instant_s});
  }
  report.tables.push_back({"quadrature", "Quadrature", std::move(quadrature)});
  report.tables.push_back({"irradiance", "Irradiance of every normal of the grid", std::move(irradiance)});
  report.charts.push_back({"quadrature", std::move(chart)});
}

}  // namespace welkin::study
