// SPDX-License-Identifier: Apache-2.0
// Surfaces, such as places with thin walls (tests/probes/leak_levels.h), as a baked level that the runtime opens.
#pragma once

#include "tests/probes/leak_levels.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {

/// The sectors, or all if there are none, without the sun. With bounces probes have the
/// light of their own places, as the fit to surfaces is no closed form.
RandomLevel bakedLevel(const geometry::Surfaces& surfaces, std::vector<geometry::SectorId> sectors = {},
                       int bounces = 0, const placement::PlacementSettings& probes = {});

/// Settings under which the rooms of a place alone end its leaks.
placement::PlacementSettings roomsOnly(const LeakLevel& level);

/// Moves surfaces, points and rooms, metres.
void move(LeakLevel& level, const Number3& by);

}  // namespace welkin::tests
