// SPDX-License-Identifier: Apache-2.0
// Which virtual lights count for a probe: those that send most bounced light to it.
#pragma once

#include <span>
#include <vector>

#include "probes/transfer/local_paths.h"

namespace welkin::transfer {

using f64::Number3;

/// A light's bounced energy at a probe, estimated: unshadowed light of `vertices` times the share that arrives. That
/// share is of the lights' tests at the vertices (`draws` each; `nearest_m` as in LocalSettings), with one test more:
/// whether light and probe see each other. 0 where all of them fail. Adds the rays it takes to `rays`.
std::vector<double> influenceOf(const geometry::Tracer& tracer, const Number3& probe,
                                std::span<const PathVertex> vertices, std::span<const Number3> lights,
                                std::size_t draws, double nearest_m, std::uint64_t& rays);

/// Indices, ascending, of the `most` largest influences above 0; of equal ones the first.
std::vector<std::size_t> mostInfluential(std::span<const double> influence, std::size_t most);

}  // namespace welkin::transfer
