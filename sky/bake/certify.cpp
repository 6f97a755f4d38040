// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/certify.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sh/spiral.h"
#include "sh/window.h"
#include "sky/bake/measured_instant.h"

namespace welkin::bake {
namespace {

using det::Number3;
using table::DayInstant;

constexpr int kFullNormals = 642;
constexpr double kFullTolerance = 1e-5;
constexpr std::size_t kQuadratureChecks = 24;  ///< number of instants at which the moments are compared with finer ones
constexpr double kConverged = 1e-9;
constexpr std::size_t kInstantsAtOnce = 1024;  ///< bounds the memory

/// An instant of a file beside that of its model.
class Measured {
 public:
  Measured(const WelkinSky* opened, const model::Sky& sky, const DayInstant& at)
      : model(sky, at), opened_(opened), sample_(sampleOf(opened, at.time_h)) {}

  const ModelInstant model;

  /// `shape` is the sky's irradiance at the normal, at intensity 1.
  void measure(const Number3& normal, const Number3& shape, InstantErrors& errors) const {
    errors.at(normal, irradianceOf(opened_, sample_, normal), model.irradiance(normal, shape));
  }

 private:
  const WelkinSky* opened_;
  WelkinSkySample sample_;
};

InstantErrors errorsAt(const Measured& instant, const table::DayValues& day, std::size_t i) {
  InstantErrors errors;
  const std::size_t normals = day.grid->count();
  for (std::size_t p = 0; p < normals; ++p)
    instant.measure(instant.model.inWorld(day.grid->normal(p).inSunFrame(), p % 2 == 0 ? 1.0 : -1.0),
                    day.value[i * normals + p], errors);
  return errors;
}

/// Largest difference between the irradiance of the baked moments and of converged ones.
double quadratureOf(const Baked& baked, const table::ErrorGrid& grid, const base::Progress& progress) {
  std::vector<double> hours;
  for (std::size_t i = 0; i < kQuadratureChecks; ++i)
    hours.push_back(format::kDay_h * (static_cast<double>(i) + 0.5) / kQuadratureChecks);
  const model::IrradianceRule* circles = baked.quadrature.circles;
  const table::DayFields fields = table::sampleDay(baked.sky, hours, baked.brightest, progress,
                                                   circles != nullptr ? *circles : model::kIrradianceRules[0]);
  const table::DayValues day(fields, grid);
  const int bands = model::IrradianceProjector::kBands;
  const model::SkyProjector converged(baked.sky.luminance, bands, kConverged);
  const model::SkyProjector as_baked(baked.sky.luminance, bands, std::max(baked.quadrature.tolerance, kConverged));
  const table::Representation r = table::coefficientsOf(day, bands, false);
  std::vector<double> error(hours.size());
  tbb::parallel_for(std::size_t{0}, error.size(), [&](std::size_t i) {
    const model::SkyInstant instant(baked.sky, hours[i]);
    const auto rowsOf = [&](const model::PolarMoments& moments) {
      std::vector<Number3> rows = moments.radiance_sh;
      if (r.rows > r.functions) rows.push_back(moments.horizontal_irradiance);
      return rows;
    };
    const auto was = rowsOf(circles == nullptr ? as_baked.projectPolar(instant) : fields.instant[i].field.moments);
    error[i] = table::differenceOf(day, r, i, was, rowsOf(converged.projectPolar(instant)));
  });
  return *std::max_element(error.begin(), error.end());
}

/// Possible error of the fast reference, divided as errors are. It is the larger of the bound for every sky and of the
/// part left out for this one.
double referenceErrorOf(const model::Sky& model, const std::vector<DayInstant>& instants) {
  const model::IrradianceProjector projector(model.luminance);
  double worst = 0.0;
  for (const DayInstant& at : instants)
    for (int c = 0; c < 3; ++c) {
      if (!(at.divisor[c] > 0.0)) continue;
      const double share = at.field.mean[c] * at.intensity / at.divisor[c];
      worst =
          std::max(worst, share * std::max(model::IrradianceProjector::kError, projector.truncationOf(at.field, c)));
    }
  return worst;
}

/// The representation at the hours of `day`, under the table's window: what a key at each of them would hold.
table::Representation keysAt(const Baked& baked, const table::DayValues& day) {
  table::Representation r = table::atHoursOf(day, baked.representation);
  if (baked.window_strength == 0.0) return r;
  const sh::Window window = sh::windowOf(baked.window_strength);
  for (std::size_t key = 0; key < r.weight.size(); key += r.rows)
    for (int l = 0; l < r.bands; ++l)
      for (int m = 0; m <= l; ++m)
        r.weight[key + model::polarIndex(l, m)] =
            r.weight[key + model::polarIndex(l, m)] * window.factor[static_cast<std::size_t>(l)];
  return r;
}

/// Sum of errors over channels and normals, with their count.
struct Mean {
  double sum = 0.0, weight = 0.0;
};

/// Adds the errors of a share of the instants.
void add(const WelkinSky* opened, const Baked& baked, Certify how, const table::DayValues& day,
         const base::Progress& progress, table::Certificate& certificate, Mean& mean) {
  const auto& instants = day.day->instant;
  static const std::vector<Number3> kSpread = [] {
    std::vector<Number3> directions;
    for (int i = 0; i < kFullNormals; ++i) directions.push_back(sh::onSpiral(1.0 - (2.0 * i + 1.0) / kFullNormals, i));
    return directions;
  }();
  const model::SkyProjector direct(baked.sky.luminance, 1, kFullTolerance);
  std::vector<InstantErrors> errors(instants.size());
  tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t i) {
    const Measured instant(opened, baked.sky, instants[i]);
    errors[i] = errorsAt(instant, day, i);
    if (how != Certify::full) return;
    for (const Number3& n : kSpread) instant.measure(n, direct.irradiance(instant.model.instant(), n), errors[i]);
    progress.step();
  });
  for (std::size_t i = 0; i < errors.size(); ++i) {
    certificate.day.push_back({instants[i].time_h, 0.0});
    for (int c = 0; c < 3; ++c) {
      const double divisor = instants[i].divisor[c];
      if (!(divisor > 0.0)) continue;
      const double error = errors[i].error[c] / divisor;
      mean.sum += errors[i].sum[c] / divisor;
      mean.weight += static_cast<double>(errors[i].normals);
      certificate.day.back().error = std::max(certificate.day.back().error, error);
      if (error <= certificate.max_error) continue;
      certificate.max_error = error;
      certificate.time_h = instants[i].time_h;
      certificate.normal = errors[i].normal[c];
      certificate.channel = c;
    }
  }
  certificate.instants += errors.size();
  certificate.reference_error = std::max(certificate.reference_error, referenceErrorOf(baked.sky, instants));
  const auto parts = table::partsOf(day, keysAt(baked, day), baked.table, baked.encoding);
  certificate.parts.truncation = std::max(certificate.parts.truncation, parts.truncation);
  certificate.parts.time = std::max(certificate.parts.time, parts.time);
  certificate.parts.encoding = std::max(certificate.parts.encoding, parts.encoding);
}

}  // namespace

std::vector<double> instantsOf(const model::Sky& sky, const table::DayTable& table, double step_h) {
  std::vector<double> hours = table::hoursOfInterest(sky, step_h);
  const auto& keys = table.key_time_h;
  hours.insert(hours.end(), keys.begin(), keys.end());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double next = i + 1 < keys.size() ? keys[i + 1] : keys[0] + format::kDay_h;
    hours.push_back(format::wrapTime(0.5 * (keys[i] + next)));
  }
  std::sort(hours.begin(), hours.end());
  hours.erase(std::unique(hours.begin(), hours.end()), hours.end());
  return hours;
}

const char* nameOf(Certify certify) {
  switch (certify) {
    case Certify::none:
      return "none";
    case Certify::full:
      return "full";
    case Certify::fast:
      break;
  }
  return "fast";
}

std::size_t certifySteps(const Baked& baked, Certify how) {
  return instantsOf(baked.sky, baked.table, kMinute_h).size() * (how == Certify::full ? 2 : 1) + kQuadratureChecks;
}

table::Certificate certify(const WelkinSky* opened, const Baked& baked, Certify how, const base::Progress& progress,
                           double step_h) {
  const table::ErrorGrid grid;
  table::Certificate certificate;
  certificate.method = how == Certify::full ? table::Certificate::Method::full : table::Certificate::Method::fast;
  Mean mean;
  const std::vector<double> hours = instantsOf(baked.sky, baked.table, step_h);
  for (std::size_t first = 0; first < hours.size(); first += kInstantsAtOnce) {
    const std::size_t last = std::min(first + kInstantsAtOnce, hours.size());
    const table::DayFields fields = table::sampleDay(
        baked.sky,
        {hours.begin() + static_cast<std::ptrdiff_t>(first), hours.begin() + static_cast<std::ptrdiff_t>(last)},
        baked.brightest, progress);
    add(opened, baked, how, table::DayValues(fields, grid), progress, certificate, mean);
  }
  certificate.mean_error = mean.weight > 0.0 ? mean.sum / mean.weight : 0.0;
  certificate.parts.quadrature = quadratureOf(baked, grid, progress);
  return certificate;
}

}  // namespace welkin::bake
