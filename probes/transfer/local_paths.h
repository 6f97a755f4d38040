// SPDX-License-Identifier: Apache-2.0
// Paths of a probe for local lights. They visit surface points where light may bounce on its way to the probe. All
// lights share them, and each point tests only a few lights.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/transfer/path_points.h"
#include "probes/transfer/proportional_draw.h"

namespace welkin::transfer {

using f64::Number3;

/// A point where a path meets a surface.
struct PathVertex {
  Number3 origin;     ///< just off the surface
  Number3 normal;     ///< unit, on the path's side
  Number3 reflected;  ///< radiance at the probe per unit of irradiance here: product of the albedos from here to the
                      ///< probe, over pi
  Number3 first;      ///< unit direction in which the path leaves the probe
  double draw = 0.0;  ///< in (0, 1), uniform over vertices
};

/// Appends the vertices of the paths from <= i < to, at most `bounces` for each path. Returns the number of rays
/// traced. Paths end outside the level, where no local light can reach a surface.
std::uint64_t traceVertices(const geometry::Tracer& tracer, const Number3& position, const PathPoints& points,
                            std::uint32_t from, std::uint32_t to, int bounces, std::vector<PathVertex>& vertices);

/// Irradiance of one side of a surface by a point light of radiant intensity 1, without shadows. It is the cosine over
/// the squared distance, or over the square of `nearest_m` if the light is nearer; 0 at the light itself.
double unshadowedIrradiance(const Number3& origin, const Number3& normal, const Number3& light, double nearest_m);

/// Draws lights at a vertex in proportion to their unshadowed irradiance.
class LightDraw {
 public:
  /// `lights` must outlive the object.
  LightDraw(std::span<const Number3> lights, std::size_t draws, double nearest_m)
      : light_(lights), draws_(draws), nearest_m_(nearest_m), part_(lights.size()) {}

  /// Calls visit(light, irradiance) for each light drawn at a vertex, with the irradiance that the draw represents. The
  /// mean of that irradiance over PathVertex::draw is the light's unshadowed irradiance.
  template <typename Visit>
  void at(const PathVertex& vertex, const Visit& visit) {
    for (std::size_t l = 0; l < part_.size(); ++l)
      part_[l] = unshadowedIrradiance(vertex.origin, vertex.normal, light_[l], nearest_m_);
    drawInProportion(part_, draws_, vertex.draw, visit);
  }

  /// Unshadowed irradiance of every light at the last vertex.
  std::span<const double> unshadowed() const { return part_; }

 private:
  std::span<const Number3> light_;
  std::size_t draws_;
  double nearest_m_;
  std::vector<double> part_;
};

/// Whether nothing lies between two points; glass counts.
bool seesEachOther(const geometry::Tracer& tracer, const Number3& from, const Number3& to);

/// Share of the light of one point that arrives at the other, in [0, 1].
Number3 shareBetween(const geometry::Tracer& tracer, const Number3& from, const Number3& to);

}  // namespace welkin::transfer
