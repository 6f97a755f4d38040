// SPDX-License-Identifier: Apache-2.0
// The operations that a shader's straight program consists of, each on single numbers and each there once.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "study/spirv_arithmetic.h"

namespace welkin::study {

using TraceNumbers = std::vector<TraceNumber>;

struct TraceOperation {
  enum class Kind {
    arithmetic,    ///< one number; or a function of whole vectors, whose numbers are parts of it
    fetch,         ///< of a texture
    uniform_load,  ///< of a vector or a number from a buffer
    free,          ///< parts, interpolated inputs, names of textures
  };

  Kind kind;
  SpirvOperation operation;
  std::vector<TraceNumber> operands;
  int instruction;      ///< the same for all numbers that one executed SPIR-V instruction computes
  bool needed = false;  ///< for what the shader writes
};

class TraceOperations {
 public:
  /// What is added from here on belongs to another SPIR-V instruction.
  void beginInstruction() { ++instruction_; }

  /// The operation of this kind on these operands: one that is there already, or a new one.
  TraceNumber add(TraceOperation::Kind kind, const SpirvOperation& operation, TraceNumbers operands);

  /// Arithmetic on single numbers, unless the result is known without it.
  TraceNumber compute(const SpirvOperation& operation, TraceNumbers operands);

  /// The numbers `first` .. `first` + `count` - 1 of what an operation gives.
  TraceNumbers partsOf(const TraceNumber& whole, int first, int count);

  TraceNumber selected(const TraceNumber& condition, const TraceNumber& yes, const TraceNumber& no);

  /// Marks what the number depends on.
  void need(const TraceNumber& number);

  const std::vector<TraceOperation>& all() const { return operations_; }

 private:
  std::vector<TraceOperation> operations_;
  std::map<std::pair<SpirvOperation, TraceNumbers>, int> indices_;
  int instruction_ = 0;
};

}  // namespace welkin::study
