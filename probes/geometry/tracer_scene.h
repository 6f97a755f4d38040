// SPDX-License-Identifier: Apache-2.0
// A level in Embree, as tracers share it.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "probes/geometry/tracer.h"

namespace welkin::geometry {

inline constexpr unsigned kForLight = 1;  ///< RTCRay::flags of Meets::light

inline constexpr unsigned kFixedMask = 1;  ///< RTCRay::mask of static geometry
inline constexpr unsigned kOtherMask = 2;

/// The triangles of one Embree geometry.
struct TracedPart {
  const Surfaces* surfaces;
  std::vector<std::uint32_t> triangle;  ///< index into Surfaces::triangle for each primitive
};

struct Tracer::Scene {
  const Surfaces* surfaces;
  Number3 origin;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  bool any_see_through = false;
  /// Embree's geometries: opaque and masked of static geometry, then opaque and masked of the rest.
  std::array<TracedPart, 4> part;

  Scene(const Surfaces& s, const Number3& about);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  ~Scene();

  /// The triangle of an Embree primitive, as an index into Surfaces::triangle.
  std::uint32_t triangleOf(unsigned geometry, unsigned primitive) const { return part[geometry].triangle[primitive]; }
  /// A vertex as Embree has it, from the origin.
  Number3 corner(std::uint32_t vertex) const;

 private:
  void attach(unsigned id);
};

/// The coordinate nearest to 0 within the surfaces' bounds on each axis.
Number3 nearestToZero(const Surfaces& s);

}  // namespace welkin::geometry
