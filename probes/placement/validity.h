// SPDX-License-Identifier: Apache-2.0
// Whether a probe may stand at a place: in the air, off the surfaces, and in sight of another place.
#pragma once

#include <functional>
#include <optional>

#include "probes/geometry/tracer.h"

namespace welkin::placement {

using f64::Number3;

/// A probe is inside geometry when more than this share of the rays of a fixed set meets a back: the threshold for
/// fixed rays of NVIDIA's RTXGI.
inline constexpr double kMostBacks = 0.25;

enum class Place { free, inside, too_close };

/// By 64 fixed directions over the sphere, to 64 m; backs of every surface with one side count.
/// Of two surfaces in one plane, back to back, a ray meets either: such walls need two sides or a thickness.
bool insideGeometry(const geometry::Tracer& tracer, const Number3& position);

/// The same, and whether static geometry is within clearance_m along those directions.
Place placeAt(const geometry::Tracer& tracer, const Number3& position, double clearance_m);

/// The nearest of a fixed set of places about the position, to 2 m, that is free and that `allowed` accepts. A way from
/// a place that is only too close crosses no surface.
std::optional<Number3> freePlaceNear(const geometry::Tracer& tracer, const Number3& position, double clearance_m,
                                     const std::function<bool(const Number3&)>& allowed);

/// Whether no static geometry lies between.
bool sees(const geometry::Tracer& tracer, const Number3& from, const Number3& to);

/// Metres.
double distanceOf(const Number3& a, const Number3& b);

}  // namespace welkin::placement
