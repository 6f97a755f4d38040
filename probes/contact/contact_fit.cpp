// SPDX-License-Identifier: Apache-2.0
#include "probes/contact/contact_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "probes/contact/contact_lights.h"
#include "probes/fit/least_squares.h"
#include "probes/fit/point_light.h"

namespace welkin::contact {
namespace {

/// To a factor of 1, as a share of all that points say of a vertex.
constexpr double kPull = 0.002;
constexpr double kSmooth = 0.05;  ///< of a triangle's corners, as a share of all that its points say
constexpr double kMost = 255.0 / kSteps;

/// All that the fit takes from a point: sums over the lights of products of luminances.
struct PointSums {
  double squares = 0.0;   ///< of the probes' light with itself
  double products = 0.0;  ///< of the probes' light with the traced one
};

PointSums sumsAt(const geometry::Tracer& tracer, const ContactLights& lights,
                 const std::vector<sectors::LevelLight>& probes, const fit::PointTracer& tracing,
                 const TrianglePoint& point, std::size_t index, std::uint32_t paths) {
  PointSums sums;
  if (!probes[0].at(point.position, point.normal) || !isVisible(tracer, point)) return sums;
  const fit::PointLight traced = tracing.trace({point.position, point.normal}, index, paths);
  for (std::size_t l = 0; l < probes.size(); ++l) {
    const ContactLight& light = lights.light()[l];
    const sectors::LevelIrradiance is = *probes[l].at(point.position, point.normal);
    Number3 should = traced.sky[light.sky];
    if (light.sun) should += traced.sun[*light.sun] * light.irradiance;
    const double luminance = det::luminanceOf(is.sky + is.sun_bounce);
    sums.squares += luminance * luminance;
    sums.products += luminance * det::luminanceOf(should);
  }
  return sums;
}

/// Rows that want the corners of a triangle to be alike. They carry factors to corners that few points or none tell of,
/// such as those under water.
void addSmoothness(const PlacedVertices& v, const std::vector<TrianglePoint>& points,
                   const std::vector<PointSums>& sums, std::vector<fit::Row>& rows, std::vector<double>& wanted,
                   std::vector<double>& known) {
  double all = 0.0, area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (sums[i].squares > 0.0) {
      all += points[i].area_m2 * sums[i].squares;
      area += points[i].area_m2;
    }
  const double mean = area > 0.0 ? all / area : 0.0;
  for (std::size_t i = 0; i < points.size();) {
    const auto& corner = points[i].vertex;
    double of_triangle = 0.0;
    for (; i < points.size() && points[i].vertex == corner; ++i)
      of_triangle += points[i].area_m2 * (sums[i].squares > 0.0 ? sums[i].squares : mean);
    if (!(of_triangle > 0.0)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = v.shared[corner[c]], b = v.shared[corner[(c + 1) % 3]];
      if (a == b) continue;
      rows.push_back({{{a, 1.0}, {b, -1.0}}, kSmooth * of_triangle});
      wanted.push_back(0.0);
      known[a] += rows.back().weight;
      known[b] += rows.back().weight;
    }
  }
}

/// Least squares for the factor of every place. A point's light is that of its probes times the factors of its
/// corners, by their shares.
std::vector<double> factorsOf(const PlacedVertices& v, const std::vector<TrianglePoint>& points,
                              const std::vector<PointSums>& sums) {
  std::vector<fit::Row> rows;
  std::vector<double> wanted, known(v.places, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(sums[i].squares > 0.0)) continue;
    fit::Row row;
    row.weight = points[i].area_m2 * sums[i].squares;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t place = v.shared[points[i].vertex[c]];
      row.entry.push_back({place, points[i].share[c]});
      known[place] += row.weight * points[i].share[c] * points[i].share[c];
    }
    rows.push_back(std::move(row));
    wanted.push_back(sums[i].products / sums[i].squares);
  }
  addSmoothness(v, points, sums, rows, wanted, known);
  // Each unknown is the factor times a scale that makes the diagonal 1: so the pull is the same for small triangles.
  std::vector<double> x(v.places, 1.0), scale(v.places, 1.0), moment(v.places, 0.0);
  for (std::size_t u = 0; u < v.places; ++u)
    if (known[u] > 0.0) x[u] = scale[u] = std::sqrt(known[u]);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (fit::Row::Entry& e : rows[r].entry) {
      e.factor /= scale[e.unknown];
      moment[e.unknown] += rows[r].weight * e.factor * wanted[r];
    }
  const fit::NormalMatrix matrix(v.places, rows, kPull);
  fit::solveBounded(matrix, 1, moment, x, [&](std::size_t u, std::span<double> number) {
    number[0] = std::clamp(number[0], 0.0, kMost * scale[u]);
  });
  for (std::size_t u = 0; u < v.places; ++u) x[u] = known[u] > 0.0 ? x[u] / scale[u] : 1.0;
  return x;
}

}  // namespace

std::vector<std::uint8_t> fitContact(const geometry::Tracer& tracer, const model::Sky& sky,
                                     const std::vector<sectors::SectorFile>& sectors, const PlacedVertices& vertices,
                                     const ContactSettings& settings, const base::Progress& progress) {
  const std::vector<TrianglePoint> points = pointsToFit(vertices, settings.spacing_m);
  const base::Progress shown = progress.stage("contact", points.size());
  const ContactLights lights(sky);
  const std::vector<sectors::LevelLight> probes = lights.on(sectors);
  transfer::TransferSettings transfer;
  transfer.bounces = settings.bounces;
  transfer.reach_m = settings.reach_m;
  transfer.ground_albedo = sky.ground_albedo;
  transfer.light_directions = lights.directions();
  const fit::PointTracer tracing(tracer, transfer, lights.skies());
  std::vector<PointSums> sums(points.size());
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    sums[i] = sumsAt(tracer, lights, probes, tracing, points[i], i, settings.paths);
    shown.step();
  });
  shown.check();
  const std::vector<double> factor = factorsOf(vertices, points, sums);
  std::vector<std::uint8_t> bytes;
  for (const std::uint32_t place : vertices.shared)
    bytes.push_back(static_cast<std::uint8_t>(std::floor(std::clamp(factor[place], 0.0, kMost) * kSteps + 0.5)));
  return bytes;
}

}  // namespace welkin::contact
