// SPDX-License-Identifier: Apache-2.0
// How far a model is off: on the patches that it was fitted to, and on patches that it has not seen.
#pragma once

#include <optional>
#include <vector>

#include "calibrate/model.h"

namespace welkin::calibrate {

/// CIEDE2000 of every pair without a model.
std::vector<double> differencesBefore(std::span<const Pair> pairs);

/// CIEDE2000 of every pair after the model.
std::vector<double> differences(std::span<const Pair> pairs, const Model& model);

/// CIEDE2000 of every pair, after a fit to the pairs of other groups. `group` has a number for each pair. None if the
/// pairs without a group do not determine the model.
std::optional<std::vector<double>> differencesLeftOut(std::span<const Pair> pairs, std::span<const std::size_t> group,
                                                      const ModelKind& kind);

}  // namespace welkin::calibrate
