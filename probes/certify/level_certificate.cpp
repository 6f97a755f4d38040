// SPDX-License-Identifier: Apache-2.0
#include "probes/certify/level_certificate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "probes/fit/fit_points.h"
#include "probes/reference/reference.h"
#include "sky/model/projection.h"

namespace welkin::certify {
namespace {

constexpr double kNormal95 = 1.959963984540054;

struct Point {
  fit::FitPoint at;
  double weight = 0.0;
};

/// Squares without the tracer's variance: of the error, and of the part itself.
struct PartSquares {
  double error = 0.0, nothing = 0.0;
};

/// The errors of a point at one hour.
struct PointError {
  PartSquares sky, sun_bounce, local;
  double total = 0.0, nothing = 0.0;
  double signed_total = 0.0;
  bool without = false;
};

/// Weighted means over points, and their spread.
class Mean {
 public:
  void add(double weight, double value) {
    sample_.emplace_back(weight, value);
    weight_ += weight;
    sum_ += weight * value;
  }
  double value() const { return weight_ > 0.0 ? sum_ / weight_ : 0.0; }
  RmsError rms() const {
    const double rms = std::sqrt(std::max(value(), 0.0));
    return {rms, rms > 0.0 ? interval() / (2.0 * rms) : 0.0};
  }
  /// Half of the 95 % confidence interval of the mean.
  double interval() const {
    double squares = 0.0;
    for (const auto& [weight, v] : sample_) squares += std::pow(weight * (v - value()), 2);
    return weight_ > 0.0 ? kNormal95 * std::sqrt(squares) / weight_ : 0.0;
  }

 private:
  std::vector<std::pair<double, double>> sample_;
  double weight_ = 0.0, sum_ = 0.0;
};

/// Means of a part's squares over points, and of what its error has above the part itself.
class PartMean {
 public:
  void add(double weight, const PartSquares& s) {
    error_.add(weight, s.error);
    nothing_.add(weight, s.nothing);
    excess_.add(weight, s.error - s.nothing);
  }
  PartError part() const { return {error_.rms(), nothing_.rms().rms, excess_.value() > excess_.interval()}; }

 private:
  Mean error_, nothing_, excess_;
};

/// The light of one hour: the probes', the truth, and the unit of errors.
struct Hour {
  Hour(const std::vector<sectors::SectorFile>& sectors, const model::Sky& sky, double at_h)
      : time_h(at_h), light(sectors, sky, at_h), distant(sky, at_h) {
    const model::SkyInstant instant(sky, at_h);
    const model::SkyProjector projector(sky.luminance, 2, 1e-6);
    unit = det::luminanceOf(projector.irradiance(instant, {0, 1, 0}) * instant.intensity());
  }
  double time_h;
  sectors::LevelLight light;
  reference::DistantLight distant;
  double unit;
};

PointError errorAt(const geometry::Tracer& tracer, const Hour& hour, const fit::FitPoint& p, std::size_t paths,
                   int bounces, std::uint64_t seed) {
  const auto want = reference::traceReference(tracer, hour.distant, {}, p.position, p.normal, {paths, bounces, seed});
  const auto found = hour.light.at(p.position, p.normal);
  const sectors::LevelIrradiance got = found.value_or(sectors::LevelIrradiance{});
  const auto square = [&](const Number3& is, const reference::Estimate& should) {
    // Channels of one path vary together, so the luminance's deviation is that of the channels, weighted alike.
    const double deviation = det::luminanceOf(should.standard_error);
    return (std::pow(det::luminanceOf(is - should.value), 2) - deviation * deviation) / (hour.unit * hour.unit);
  };
  const auto part = [&](const Number3& is, const reference::Estimate& should) {
    return PartSquares{square(is, should), square(Number3(0.0), should)};
  };
  return {part(got.sky, want.sky),
          part(got.sun_bounce, want.sun_bounce),
          part(got.local, want.local),
          square(got.total(), want.total),
          square(Number3(0.0), want.total),
          det::luminanceOf(got.total() - want.total.value) / hour.unit,
          !found.has_value()};
}

/// Points of all sectors. Those of a sector share its area.
void addPoints(const geometry::Tracer& tracer, const std::vector<sectors::SectorFile>& sectors,
               const CertifySettings& settings, std::vector<Point>& surface, std::vector<Point>& air) {
  const auto each = [&](std::size_t of_all) {
    return std::max<std::size_t>(1, (of_all + sectors.size() - 1) / sectors.size());
  };
  std::vector<fit::FitPoints> points(sectors.size());
  tbb::parallel_for(std::size_t{0}, sectors.size(), [&](std::size_t i) {
    points[i] = fit::pointsOf(tracer, sectors[i].id, each(settings.surface_points), each(settings.air_points),
                              settings.seed + i);
  });
  for (const fit::FitPoints& of : points) {
    for (const fit::FitPoint& p : of.surface)
      surface.push_back({p, of.surface_m2 / static_cast<double>(of.surface.size())});
    for (const fit::FitPoint& p : of.air) air.push_back({p, of.air_m2 / static_cast<double>(of.air.size())});
  }
}

/// [hour][point]
using ErrorTable = std::vector<std::vector<PointError>>;

ErrorsOf summary(const std::vector<Point>& points, const ErrorTable& table, std::size_t from, std::size_t to) {
  PartMean sky, sun, local;
  Mean total, nothing, without;
  const double share = 1.0 / static_cast<double>(to - from);
  for (std::size_t p = 0; p < points.size(); ++p) {
    PointError mean;
    for (std::size_t h = from; h < to; ++h) {
      const PointError& e = table[h][p];
      for (PartSquares PointError::*part : {&PointError::sky, &PointError::sun_bounce, &PointError::local}) {
        (mean.*part).error += (e.*part).error * share;
        (mean.*part).nothing += (e.*part).nothing * share;
      }
      mean.total += e.total * share;
      mean.nothing += e.nothing * share;
      mean.without = e.without;
    }
    sky.add(points[p].weight, mean.sky);
    sun.add(points[p].weight, mean.sun_bounce);
    local.add(points[p].weight, mean.local);
    total.add(points[p].weight, mean.total);
    nothing.add(points[p].weight, mean.nothing);
    without.add(points[p].weight, mean.without ? 1.0 : 0.0);
  }
  return {sky.part(), sun.part(), local.part(), total.rms(), nothing.rms(), without.value()};
}

std::vector<WorstPoint> worstOf(const std::vector<Point>& points, const ErrorTable& table,
                                const std::vector<double>& time_h) {
  std::vector<WorstPoint> all;
  for (std::size_t p = 0; p < points.size(); ++p) {
    WorstPoint worst{points[p].at.position, points[p].at.normal, 0.0, 0.0};
    for (std::size_t h = 0; h < table.size(); ++h)
      if (std::abs(table[h][p].signed_total) >= std::abs(worst.error)) {
        worst.error = table[h][p].signed_total;
        worst.time_h = time_h[h];
      }
    all.push_back(worst);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const WorstPoint& a, const WorstPoint& b) { return std::abs(a.error) > std::abs(b.error); });
  all.resize(std::min({all.size(), kMostWorst, (all.size() + 99) / 100}));
  return all;
}

/// The middle of each third of the time that the sun is up; of the 24 hours if it is never up or never down.
std::vector<double> thirdsOfDay(const model::Sky& sky) {
  constexpr int kSteps = 24 * 12;
  double first = 24.0, last = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double time_h = 24.0 * i / kSteps;
    if (sky.sun.path.directionAt(time_h).y <= 0.0) continue;
    first = std::min(first, time_h);
    last = std::max(last, time_h);
  }
  if (!(last > first)) {
    first = 0.0;
    last = 24.0;
  }
  return {first + (last - first) / 6.0, (first + last) / 2.0, last - (last - first) / 6.0};
}

}  // namespace

LevelCertificate certifyLevel(const geometry::Tracer& tracer, const model::Sky& sky,
                              const std::vector<sectors::SectorFile>& sectors, const CertifySettings& settings,
                              const base::Progress& progress) {
  LevelCertificate result;
  if (sectors.empty()) return result;
  std::vector<Point> surface, air;
  addPoints(tracer, sectors, settings, surface, air);
  result.surface_points = surface.size();
  result.air_points = air.size();
  for (const Point& p : surface) result.surface_m2 += p.weight;
  for (const Point& p : air) result.air_m2 += p.weight;
  const auto errorsAt = [&](const Hour& hour, const std::vector<Point>& points, std::size_t count, std::size_t paths) {
    std::vector<PointError> errors(std::min(count, points.size()));
    tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t p) {
      errors[p] = errorAt(tracer, hour, points[p * points.size() / errors.size()].at, paths, settings.bounces,
                          geometry::Random(settings.seed, p, std::llround(hour.time_h * 3600.0)).next());
      progress.step(paths);
    });
    return errors;
  };
  std::vector<double> time_h;
  if (settings.all_hours) {
    for (int h = 0; h < 24; ++h) time_h.push_back(h);
  } else {
    constexpr std::size_t kFewPoints = 16, kFewPaths = 64;
    time_h = thirdsOfDay(sky);
    double worst = -1.0, worst_h = 0.0;
    for (int h = 0; h < 24; ++h) {
      double sum = 0.0;
      for (const PointError& e : errorsAt(Hour(sectors, sky, h), surface, kFewPoints, kFewPaths)) sum += e.total;
      if (sum <= worst) continue;
      worst = sum;
      worst_h = h;
    }
    time_h.push_back(worst_h);
    std::sort(time_h.begin(), time_h.end());
  }
  ErrorTable of_surface, of_air;
  for (const double at_h : time_h) {
    const Hour hour(sectors, sky, at_h);
    of_surface.push_back(errorsAt(hour, surface, surface.size(), settings.paths));
    of_air.push_back(errorsAt(hour, air, air.size(), settings.paths));
  }
  for (std::size_t h = 0; h < time_h.size(); ++h)
    result.hour.push_back({time_h[h], summary(surface, of_surface, h, h + 1), summary(air, of_air, h, h + 1)});
  result.surface = summary(surface, of_surface, 0, time_h.size());
  result.air = summary(air, of_air, 0, time_h.size());
  result.worst = worstOf(surface, of_surface, time_h);
  return result;
}

}  // namespace welkin::certify
