// SPDX-License-Identifier: Apache-2.0
// Traces rays through a level with Embree, and describes the surface where they hit.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

using f64::Number3;

/// A surface on a ray. The unit normal belongs to the triangle's plane, on the side that the ray comes from.
struct Hit {
  double distance = 0.0;
  Number3 position;
  Number3 normal;
  std::uint32_t triangle = 0;
  double u = 0.0, v = 0.0;  ///< barycentric coordinates of the second and third vertex
  bool back = false;        ///< the ray hit the back of a one-sided surface
  double coarsest_m = 0.0;  ///< largest coordinate of the triangle from the tracer's origin: Embree's distance to its
                            ///< plane is as coarse
  Number3 back_along{0.0};  ///< unit direction to where the ray came from; 0 for a point that no ray found
};

/// The surfaces that a ray meets: every surface, or static geometry only (vegetation and water let it pass). The first
/// two are for places: a blended surface is there where its alpha is alpha_cutoff or more. For `light` every surface is
/// there, and how much of it is the light's own business (see_through.h).
enum class Meets { all, fixed, light };

/// Immutable after construction; any thread may trace any ray. Results have the same bits on every machine with kIsa,
/// because Embree runs robust and with this instruction set only.
class Tracer {
 public:
  static constexpr const char* kIsa = "avx2";

  /// `surfaces` must outlive the tracer. Embree's floats count from an origin in multiples of kSector_m: the one below
  /// `about`, or without it the one nearest to 0 within the surfaces' bounds. So rays are as exact far out as at 0.
  /// Throws Error(file) if the processor lacks kIsa or memory runs out.
  explicit Tracer(const Surfaces& surfaces, const std::optional<Number3>& about = {});
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// A tracer of the same level that sees no farther than `reach_m` along x and z from `about`, at any height. Rays end
  /// where they leave that square. The copy shares the level and costs nothing.
  Tracer within(const Number3& about, double reach_m) const;
  /// The distance at which a ray leaves that square; 0 if it starts outside, infinite without a square.
  double leavesAfter(const Number3& origin, const Number3& direction) const;

  /// The nearest surface in a unit direction, or nothing within `far`. Rays pass through masked texels.
  std::optional<Hit> closest(const Number3& origin, const Number3& direction, double far,
                             Meets meets = Meets::all) const;
  /// All surfaces in a unit direction within `far`, nearest first, each triangle once. This takes the time of about one
  /// ray, however many surfaces there are.
  std::vector<Hit> all(const Number3& origin, const Number3& direction, double far, Meets meets = Meets::all) const;
  /// Whether closest() would find a surface.
  bool occluded(const Number3& origin, const Number3& direction, double far, Meets meets = Meets::all) const;

  /// Whether closest() would find the back of a one-sided surface.
  bool meetsBack(const Number3& origin, const Number3& direction, double far) const;

  /// Whether any point of static geometry is nearer than a distance >= 0, in any direction. Masked texels count as
  /// surface.
  bool isNearer(const Number3& position, double distance_m) const;

  /// A point of a surface, or in the air, as a hit that no ray found. A ray that leaves it starts as far off the
  /// surface as one that had found it. `normal` is a unit vector; it may be a smooth one. Only position, normal and
  /// coarsest_m are set.
  Hit pointOn(const Number3& position, const Number3& normal) const;

  /// The start of a ray that leaves the hit: off the plane on the normal's side, by more than the rounding of floats.
  /// It also moves back along the ray that found the hit, where that way was free. So it does not start in or behind a
  /// wall that stands on the surface there.
  Number3 leaving(const Hit& hit) const;

  /// The start of a ray that passes the surface that it met: off the plane on the other side.
  Number3 beyond(const Hit& hit) const;

  /// Whether light passes some surface of the level.
  bool anySeeThrough() const;
  /// Share of the light that passes the surface straight on, linear, in [0, 1]. Thin glass: no light is bent.
  Number3 passing(const Hit& hit) const;
  /// Diffuse albedo, linear, in [0, 1]; 0 on the back of a one-sided surface that no light passes. `passing` and this
  /// sum to at most 1.
  Number3 albedo(const Hit& hit) const;
  /// Emitted radiance; 0 on the back of a one-sided surface that no light passes.
  Number3 emission(const Hit& hit) const;

  const Surfaces& surfaces() const;
  /// The place in the world of Embree's (0, 0, 0).
  const Number3& origin() const;

 private:
  struct Scene;
  struct Met;
  struct Square {
    double low_x = -std::numeric_limits<double>::infinity(), high_x = std::numeric_limits<double>::infinity();
    double low_z = low_x, high_z = high_x;
  };
  Tracer(std::shared_ptr<const Scene> scene, const Square& square);
  std::optional<Met> meet(const Number3& origin, const Number3& direction, double far, Meets meets) const;
  Hit hitOf(const Met& met, const Number3& direction) const;

  std::shared_ptr<const Scene> scene_;
  Square square_;
};

}  // namespace welkin::geometry
