// SPDX-License-Identifier: Apache-2.0
// Decides whether a probe may stand at a place: in the air, off the surfaces, and in sight of another place.
#pragma once

#include <functional>
#include <optional>

#include "probes/geometry/tracer.h"

namespace welkin::placement {

using f64::Number3;

/// A probe is inside geometry if more than this share of a fixed set of rays meets a back. The value is RTXGI's
/// threshold for fixed rays (NVIDIA).
inline constexpr double kMostBacks = 0.25;

enum class Place { free, inside, too_close };

/// Tests 64 fixed directions over the sphere, to 64 m; backs of all one-sided surfaces count. If two surfaces lie back
/// to back in one plane, a ray may meet either. Such walls need two sides or a thickness.
bool insideGeometry(const geometry::Tracer& tracer, const Number3& position);

/// The same test, and whether static geometry is within clearance_m and a millimetre in any direction.
Place placeAt(const geometry::Tracer& tracer, const Number3& position, double clearance_m);

/// A search for a free place.
struct Search {
  std::optional<Number3> found;
  std::size_t rays = 0;  ///< that it took; a look for the nearest surface counts as one
};

/// The nearest free place within 2 m, from a fixed set around the position, that `allowed` accepts. If the position is
/// only too close, the way from it crosses no surface.
Search freePlaceNear(const geometry::Tracer& tracer, const Number3& position, double clearance_m,
                     const std::function<bool(const Number3&)>& allowed);

/// Whether no static geometry lies between the two points.
bool sees(const geometry::Tracer& tracer, const Number3& from, const Number3& to);

/// Distance in metres.
double distanceOf(const Number3& a, const Number3& b);

}  // namespace welkin::placement
