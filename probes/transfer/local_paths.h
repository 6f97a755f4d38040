// SPDX-License-Identifier: Apache-2.0
// The paths of a probe for local lights: surface points that light may bounce off on its way to the probe, shared by
// all lights, and the choice of the few lights that each of them tests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/transfer/path_points.h"

namespace welkin::transfer {

using f64::Number3;

/// Where a path meets a surface.
struct PathVertex {
  Number3 origin;     ///< just off the surface
  Number3 normal;     ///< unit, on the path's side
  Number3 reflected;  ///< radiance at the probe of unit irradiance here: albedos from here to the probe over pi
  Number3 first;      ///< direction in which the path leaves the probe, unit
  double draw = 0.0;  ///< in (0, 1), uniform over vertices
};

/// Appends the vertices of paths from <= i < to, at most `bounces` each; returns the rays that it took. Beyond the
/// level there is nothing that a local light could reach.
std::uint64_t traceVertices(const geometry::Tracer& tracer, const Number3& position, const PathPoints& points,
                            std::uint32_t from, std::uint32_t to, int bounces, std::vector<PathVertex>& vertices);

/// Irradiance, with nothing in its way, of one side of a surface by a point light of radiant intensity 1: cosine over
/// the square of the distance, or of `nearest_m` where that is more; 0 at the light itself.
double unshadowedIrradiance(const Number3& origin, const Number3& normal, const Number3& light, double nearest_m);

/// Lights at a vertex, drawn in proportion to their unshadowed irradiance: systematic sampling, or all where they are
/// no more than the draws (Ward, "Adaptive Shadow Testing for Ray Tracing", 1991, sorts by the same number).
class LightDraw {
 public:
  /// `lights` outlives it.
  LightDraw(std::span<const Number3> lights, std::size_t draws, double nearest_m)
      : light_(lights), draws_(draws), nearest_m_(nearest_m), part_(lights.size()) {}

  /// Asks of the lights at a vertex: visit(light, irradiance) for each one drawn, with what the draw stands for; its
  /// mean over PathVertex::draw is the light's unshadowed irradiance.
  template <typename Visit>
  void at(const PathVertex& vertex, const Visit& visit) {
    double total = 0.0;
    std::size_t lit = 0;
    for (std::size_t l = 0; l < part_.size(); ++l) {
      part_[l] = unshadowedIrradiance(vertex.origin, vertex.normal, light_[l], nearest_m_);
      total += part_[l];
      if (part_[l] > 0.0) ++lit;
    }
    if (lit <= draws_) {
      for (std::size_t l = 0; l < part_.size(); ++l)
        if (part_[l] > 0.0) visit(l, part_[l]);
      return;
    }
    const double step = total / static_cast<double>(draws_);
    double sum = 0.0;
    std::size_t drawn = 0;
    for (std::size_t l = 0; l < part_.size() && drawn < draws_; ++l) {
      sum += part_[l];
      std::size_t times = 0;
      for (; drawn < draws_ && (static_cast<double>(drawn) + vertex.draw) * step < sum; ++drawn) ++times;
      if (times > 0) visit(l, static_cast<double>(times) * step);
    }
  }

  /// Irradiance of every light at the last vertex, with nothing in its way.
  std::span<const double> unshadowed() const { return part_; }

 private:
  std::span<const Number3> light_;
  std::size_t draws_;
  double nearest_m_;
  std::vector<double> part_;
};

/// Whether nothing lies between two points.
bool seesEachOther(const geometry::Tracer& tracer, const Number3& from, const Number3& to);

}  // namespace welkin::transfer
