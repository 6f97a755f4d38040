// SPDX-License-Identifier: Apache-2.0
// The shared formulas on the CPU, as floats and as doubles, for the same arguments.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace welkin::numerics {

/// One result of an evaluation: a formula's value, or a component of it.
struct Slot {
  std::string formula;
  std::string arguments;  ///< names of those that matter
};

/// The results of an evaluation, in its order.
const std::vector<Slot>& slots();

/// Value and size (formulas.h) of every slot.
struct Values {
  std::vector<double> value;
  std::vector<double> size;
};

void evaluateAsFloats(std::span<const float> arguments, Values& out);
void evaluateAsDoubles(std::span<const float> arguments, Values& out);

/// Arguments of the evaluations from `first` on. They are uniform, or near the edges of a formula: directions at the
/// poles, on the horizon and close to each other, small angles, small exponents, dark colours. Every call gives the
/// same arguments.
std::vector<float> drawArguments(std::size_t first, std::size_t count);

/// The arguments that matter to a slot, in words.
std::string describe(const Slot& slot, std::span<const float> arguments);

}  // namespace welkin::numerics
