// SPDX-License-Identifier: Apache-2.0
// What is known while the instructions of a SPIR-V module are followed one after the other: values, variables, and the
// operations that they are made of.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "study/spirv_memory.h"
#include "study/spirv_module.h"
#include "study/trace_operations.h"

namespace welkin::study {

/// Numbers of the variables that the shader writes to.
using SpirvMemory = std::map<std::uint32_t, TraceNumbers>;

/// Everything throws Error(internal) for what cannot be followed.
class SpirvState {
 public:
  explicit SpirvState(const SpirvModule& module);

  /// An instruction that neither is a phi nor ends a block.
  void execute(const SpirvInstruction& instruction);

  const TraceNumbers& valueOf(std::uint32_t id);
  void setValue(const SpirvInstruction& phi, TraceNumbers numbers);

  SpirvMemory& memory() { return memory_; }

  /// Of the two sides of a branch: `yes` and what is there now.
  void joinMemory(const TraceNumber& condition, const SpirvMemory& yes);

  /// Marks what the outputs depend on.
  void needOutputs();

  TraceOperations& operations() { return operations_; }

 private:
  const SpirvType& typeOf(std::uint32_t id) const;
  std::size_t count(std::uint32_t type) const;
  void addGlobal(std::uint32_t id, const SpirvInstruction& global);
  void addVariable(const SpirvInstruction& variable);
  TraceNumbers joined(const std::vector<std::uint32_t>& ids, std::size_t from);
  TraceNumbers load(const SpirvPointer& pointer);
  void store(const SpirvPointer& pointer, const TraceNumbers& numbers);
  SpirvPointer literalPart(const std::vector<std::uint32_t>& operands, std::size_t whole) const;
  TraceNumbers extracted(const SpirvInstruction& instruction);
  TraceNumbers inserted(const SpirvInstruction& instruction);
  TraceNumbers shuffled(const SpirvInstruction& instruction);
  TraceNumbers computed(const SpirvInstruction& instruction);

  const SpirvModule& module_;
  TraceOperations operations_;
  std::map<std::uint32_t, TraceNumbers> values_;
  std::map<std::uint32_t, std::uint32_t> types_of_values_;
  std::map<std::uint32_t, SpirvPointer> pointers_;
  SpirvMemory memory_;
};

}  // namespace welkin::study
