// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/fit_transfer.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "probes/fit/sky_fit.h"
#include "probes/transfer/transfer_basis.h"

namespace welkin::fit {
namespace {

constexpr std::uint64_t kSeed = 0x5eed;

/// The rows of the matrix, and the points that they are of.
struct Rows {
  std::vector<Row> row;
  std::vector<FitPoint> point;

  /// Returns whether a probe serves the point. Unlit probes learn nothing: a closed room stays dark, whatever places
  /// outside may take from its probes. Their part of the light is 0.
  bool add(const LookUp& look_up, const std::vector<bool>& is_unlit, const FitPoint& p) {
    const PointWeights weights = look_up.at(p);
    if (weights.probe.empty()) return false;
    const auto shading = transfer::shadingWeights(p.normal);
    Row r;
    r.weight = weights.share * weights.share;
    for (const PointWeights::Entry& e : weights.probe)
      for (std::size_t b = 0; b < transfer::kDirections; ++b)
        if (shading[b] != 0.0 && !is_unlit[e.probe])
          r.entry.push_back({static_cast<std::uint32_t>(transfer::kDirections * e.probe + b), e.weight * shading[b]});
    if (r.entry.empty()) return true;
    row.push_back(std::move(r));
    point.push_back(p);
    return true;
  }
};

/// Bounced light of sun and moon, and emitted light: one column for each light's channel.
void fitLights(const NormalMatrix& matrix, const Rows& rows, std::span<const PointLight> light,
               std::span<transfer::ProbeTransfer* const> probes) {
  const std::size_t lights = probes[0]->sun[0].size();
  const std::size_t columns = 3 * (lights + 1);
  const auto of = [&](std::size_t u, std::size_t i) -> Number3& {
    transfer::ProbeTransfer& t = *probes[u / transfer::kDirections];
    return i < lights ? t.sun[u % transfer::kDirections][i] : t.emitted[u % transfer::kDirections];
  };
  std::vector<double> x(matrix.unknowns() * columns), moment(x.size(), 0.0);
  for (std::size_t u = 0; u < matrix.unknowns(); ++u)
    for (std::size_t i = 0; i < columns; ++i) x[u * columns + i] = of(u, i / 3)[static_cast<int>(i % 3)];
  for (std::size_t p = 0; p < rows.row.size(); ++p)
    for (const Row::Entry& e : rows.row[p].entry)
      for (std::size_t i = 0; i < columns; ++i) {
        const Number3& wanted = i / 3 < lights ? light[p].sun[i / 3] : light[p].emitted;
        moment[e.unknown * columns + i] += rows.row[p].weight * e.factor * wanted[static_cast<int>(i % 3)];
      }
  solveBounded(matrix, columns, moment, x, [](std::size_t, std::span<double> numbers) {
    for (double& v : numbers) v = std::max(v, 0.0);
  });
  for (std::size_t u = 0; u < matrix.unknowns(); ++u)
    for (std::size_t i = 0; i < columns; ++i) of(u, i / 3)[static_cast<int>(i % 3)] = x[u * columns + i];
}

}  // namespace

FitReport fitTransfer(const geometry::Tracer& tracer, const geometry::PlacedSector& sector,
                      const placement::SectorCuts& cuts, const transfer::TransferSettings& settings,
                      std::span<transfer::ProbeTransfer* const> probes, const base::Progress& progress,
                      const FitSettings& fit) {
  FitReport report;
  if (probes.empty()) return report;
  const FitPoints points =
      pointsOf(tracer, sector.id, fit.surface_points * probes.size(), fit.air_points * probes.size(), kSeed);
  const LookUp look_up(sector, cuts);
  std::vector<bool> is_unlit;
  for (const transfer::ProbeTransfer* t : probes) is_unlit.push_back(transfer::isUnlit(*t));
  Rows rows;
  for (const FitPoint& p : points.surface) report.surface_without += rows.add(look_up, is_unlit, p) ? 0 : 1;
  for (const FitPoint& p : points.air) rows.add(look_up, is_unlit, p);
  report.points = rows.row.size();
  const TrainingSkies skies(settings.light_directions);
  const PointTracer tracing(tracer, settings, skies);
  std::vector<PointLight> light(rows.point.size());
  tbb::parallel_for(std::size_t{0}, light.size(), [&](std::size_t i) {
    light[i] = tracing.trace(rows.point[i], i, fit.paths);
    progress.step(light[i].rays);
  });
  for (const PointLight& l : light) report.rays += l.rays;
  progress.check();
  const NormalMatrix matrix(transfer::kDirections * probes.size(), rows.row, fit.pull);
  fitSky(matrix, rows.row, light, skies, probes);
  fitLights(matrix, rows, light, probes);
  return report;
}

}  // namespace welkin::fit
