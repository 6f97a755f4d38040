// SPDX-License-Identifier: Apache-2.0
// Chooses the virtual lights that send the most bounced light to a probe.
#pragma once

#include <span>
#include <vector>

#include "probes/transfer/local_paths.h"

namespace welkin::transfer {

using f64::Number3;

/// Estimates each light's bounced energy at a probe: its unshadowed light at `vertices` times the share that arrives.
/// The share comes from the light's shadow tests at the vertices, `draws` at each, with `nearest_m` as in
/// LocalSettings. One more test asks whether light and probe see each other. The estimate is 0 if all tests fail. Adds
/// the rays traced to `rays`.
std::vector<double> influenceOf(const geometry::Tracer& tracer, const Number3& probe,
                                std::span<const PathVertex> vertices, std::span<const Number3> lights,
                                std::size_t draws, double nearest_m, std::uint64_t& rays);

/// Indices, ascending, of the `most` largest influences above 0. Among equal ones the first wins.
std::vector<std::size_t> mostInfluential(std::span<const double> influence, std::size_t most);

}  // namespace welkin::transfer
