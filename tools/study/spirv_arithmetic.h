// SPDX-License-Identifier: Apache-2.0
// SPIR-V's operations on single numbers: which work number by number, and what they give for operands that are known,
// by the rules that spirv-opt has for whole vectors.
#pragma once

#include <cstdint>
#include <optional>
#include <spirv/unified1/spirv.hpp11>
#include <vector>

namespace welkin::study {

/// What an instruction computes: an operation, or for OpExtInst a function of GLSL.std.450.
struct SpirvOperation {
  spv::Op op;
  std::uint32_t function = 0;

  auto operator<=>(const SpirvOperation&) const = default;
};

/// A number while a module is followed: known, or the result of an operation of the trace.
struct TraceNumber {
  bool known = true;
  double value = 0.0;  ///< integers and truth values too
  int operation = 0;   ///< index, when it is not known

  auto operator<=>(const TraceNumber&) const = default;
};

/// Whether component i of the result depends on the components i of the operands alone; operands of one component count
/// for all.
bool worksByComponent(const SpirvOperation& operation);

/// What comes out without an operation: of known numbers, or of x * 0, x * 1, x + 0 and their like.
std::optional<TraceNumber> simplified(const SpirvOperation& operation, const std::vector<TraceNumber>& operands);

}  // namespace welkin::study
