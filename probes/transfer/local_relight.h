// SPDX-License-Identifier: Apache-2.0
// From dynamic lights to virtual ones and on to a probe's irradiance: the reference, in double, of what the runtime
// does. Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012).
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "probes/transfer/local_transfer.h"
#include "probes/transfer/transfer_basis.h"

namespace welkin::transfer {

using f64::Number3;

/// Whether two points see each other: without that a lamp would leak through a wall to the light behind it.
using SeeEachOther = std::function<bool(const Number3& virtual_light, const Number3& dynamic_light)>;

struct LocalColours {
  std::vector<Number3> colour;      ///< radiant intensity of each virtual light
  std::vector<std::size_t> unseen;  ///< dynamic lights that no virtual light sees: they are in none
};

/// Shares each dynamic light among the virtual lights that see it, nearest first: within 1.5 times the distance R of
/// the fourth (of the last where fewer see it) with weights (1 / d - 1 / (1.5 R))^2 over their sum; one that is in its
/// very place takes all. Weights change continuously with the distances (Franke and Nielson, "Smooth Interpolation of
/// Large Sets of Scattered Data", 1980). The sum of `colour` is that of the lights seen.
LocalColours relightLocal(std::span<const Number3> virtual_lights, std::span<const geometry::PointLight> dynamic_lights,
                          const SeeEachOther& see_each_other);

/// Bounced irradiance by direction of the transfer basis, pi included: sum over lights of colour times the radiance's
/// product with the direction's cosine lobe, 2 bands. It may be below 0 in a direction from which hardly any comes.
std::array<Number3, kDirections> relitLocal(std::span<const LocalTransfer> transfer, std::span<const Number3> colour);

}  // namespace welkin::transfer
