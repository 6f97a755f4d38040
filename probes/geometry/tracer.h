// SPDX-License-Identifier: Apache-2.0
// Rays through a level (Embree), and what the surface is where they hit.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

using f64::Number3;

/// A surface on a ray. The normal is of the triangle's plane, unit, on the side that the ray comes from.
struct Hit {
  double distance = 0.0;
  Number3 position;
  Number3 normal;
  std::uint32_t triangle = 0;
  double u = 0.0, v = 0.0;  ///< barycentric, of the second and third vertex
  bool back = false;        ///< of a surface with one side only
  double coarsest_m = 0.0;  ///< largest coordinate of the triangle: Embree's distance to its plane is as coarse as that
  Number3 back_along{0.0};  ///< to where the ray came from, unit; 0: a point that no ray found
};

/// What a ray meets: every surface, or static geometry only (vegetation and water let it pass).
enum class Meets { all, fixed };

/// Immutable after construction; every ray may be traced from any thread. The same bits on every machine with the
/// stated ISA: Embree runs robust and with one instruction set (kIsa).
class Tracer {
 public:
  static constexpr const char* kIsa = "avx2";

  /// `surfaces` outlives the tracer. Throws Error(file) where the processor lacks kIsa, or memory runs out.
  explicit Tracer(const Surfaces& surfaces);
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// The same level, seen no farther than `reach_m` along x and z from `about`, at any height: rays end where they
  /// leave that square. Shares all that the level takes; costs nothing.
  Tracer within(const Number3& about, double reach_m) const;
  /// The distance at which a ray leaves that square, 0 where it starts beyond; infinite without one.
  double leavesAfter(const Number3& origin, const Number3& direction) const;

  /// The nearest surface in a unit direction, masked texels passed through; none within `far`.
  std::optional<Hit> closest(const Number3& origin, const Number3& direction, double far,
                             Meets meets = Meets::all) const;
  /// Whether anything lies between, as above.
  bool occluded(const Number3& origin, const Number3& direction, double far, Meets meets = Meets::all) const;

  /// Where a ray that leaves the hit starts: off the plane, on the normal's side, by more than the rounding of floats;
  /// and back along the ray that found it, where the way was free, so that it does not start in or behind a wall that
  /// stands on the surface there.
  Number3 leaving(const Hit& hit) const;

  /// Diffuse albedo, linear, in [0, 1]; 0 on a back.
  Number3 albedo(const Hit& hit) const;
  /// Radiance that it emits; 0 on a back.
  Number3 emission(const Hit& hit) const;

  const Surfaces& surfaces() const;

 private:
  struct Scene;
  struct Square {
    double low_x = -std::numeric_limits<double>::infinity(), high_x = std::numeric_limits<double>::infinity();
    double low_z = low_x, high_z = high_x;
  };
  Tracer(std::shared_ptr<const Scene> scene, const Square& square);

  std::shared_ptr<const Scene> scene_;
  Square square_;
};

}  // namespace welkin::geometry
