// SPDX-License-Identifier: Apache-2.0
// Models of a camera: functions from its linear colours to a chart's, fitted to pairs of both. A new model is one entry
// of models() and its two functions.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "calibrate/colour_space.h"

namespace welkin::calibrate {

/// One patch: linear Rec. 709 as photographed and as wanted.
struct Pair {
  Colour measured;
  Colour wanted;
};

struct ModelKind {
  const char* name;
  /// The model's numbers; none if the pairs do not determine them.
  std::optional<std::vector<double>> (*fit)(std::span<const Pair> pairs);
  /// Linear Rec. 709 of a photographed colour. It is finite for finite colours.
  Colour (*apply)(std::span<const double> numbers, const Colour& measured);
  std::size_t count;  ///< of the numbers
};

/// A kind with its numbers.
struct Model {
  const ModelKind* kind = nullptr;
  std::vector<double> numbers;

  Colour operator()(const Colour& measured) const { return kind->apply(numbers, measured); }
};

std::span<const ModelKind> models();

/// Null for a name that no model has.
const ModelKind* modelNamed(std::string_view name);

/// The names with commas between them, for messages.
std::string_view modelNames();

}  // namespace welkin::calibrate
