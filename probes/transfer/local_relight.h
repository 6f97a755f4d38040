// SPDX-License-Identifier: Apache-2.0
// Shares dynamic lights among virtual ones and computes a probe's irradiance from these. It is the double-precision
// reference for the runtime. Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012).
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "probes/transfer/local_transfer.h"
#include "probes/transfer/transfer_basis.h"

namespace welkin::transfer {

using f64::Number3;

/// A dynamic light: a lamp, or a spot within a cone as glTF's KHR_lights_punctual has it.
struct DynamicLight {
  Number3 position;                                ///< metres
  Number3 intensity;                               ///< radiant intensity on the axis
  Number3 axis{0, -1, 0};                          ///< unit
  double inner_rad = 0.0;                          ///< angles off the axis, 0 <= inner <= outer <= pi;
  std::optional<double> outer_rad = std::nullopt;  ///< without, the light is a lamp
};

/// Share of a dynamic light's intensity in a direction, by the cosine of its angle off the axis.
double coneShareOf(const DynamicLight& light, double cosine);

/// Whether two points see each other. Without this test a lamp would leak through a wall to the light behind it.
using SeeEachOther = std::function<bool(const Number3& virtual_light, const Number3& dynamic_light)>;

struct LocalColours {
  std::vector<Number3> colour;      ///< radiant intensity of each virtual light
  std::vector<std::size_t> unseen;  ///< dynamic lights that no virtual light sees; they are left out
};

/// Shares each dynamic light among the virtual lights that see it. R is the distance of the fourth nearest, or of the
/// last if fewer see it. Lights within 1.5 R get weights (1 / d - 1 / (1.5 R))^2, divided by their sum. A virtual light
/// at the very place of the dynamic one takes all of it. Weights change continuously with the distances (Franke and
/// Nielson, "Smooth Interpolation of Large Sets of Scattered Data", 1980). The sum of `colour` is the sum of the lights
/// seen.
///
/// Of a spot, the light on the whole sphere is shared, and the weights are times 1/16 plus the cone's share in the
/// virtual light's direction. So the places that it shines at take 17 times as much as others, and shares change
/// continuously as it turns.
LocalColours relightLocal(std::span<const Number3> virtual_lights, std::span<const DynamicLight> dynamic_lights,
                          const SeeEachOther& see_each_other);

/// Bounced irradiance by direction of the transfer basis, pi included. It sums, over lights, the colour times the
/// product of radiance and cosine lobe in 2 bands. It may be below 0 in a direction from which hardly any light comes.
std::array<Number3, kDirections> relitLocal(std::span<const LocalTransfer> transfer, std::span<const Number3> colour);

}  // namespace welkin::transfer
