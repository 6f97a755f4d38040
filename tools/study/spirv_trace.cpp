// SPDX-License-Identifier: Apache-2.0
#include "study/spirv_trace.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "sky/base/error.h"
#include "study/spirv_flow.h"
#include "study/spirv_state.h"

namespace welkin::study {
namespace {

using spv::Op;

constexpr int kMostBlocks = 100000;  // executed
constexpr int kMostNested = 64;      // branches that depend on data

[[noreturn]] void refuse(const std::string& why) {
  throw base::Error(base::ExitStatus::internal, "SPIR-V: " + why);
}

// Values of the phis at the head of a block, in their order.
using Phis = std::vector<TraceNumbers>;

class Tracer {
 public:
  explicit Tracer(const SpirvModule& module) : module_(module), joins_(joinsOf(module)), state_(module) {}

  std::vector<TraceOperation> trace() {
    flow(module_.first_block, {}, kExit);
    state_.needOutputs();
    return state_.operations().all();
  }

 private:
  Phis phisAt(std::uint32_t block, std::uint32_t from) {
    Phis phis;
    if (block == kExit) return phis;
    for (const SpirvInstruction& instruction : module_.blocks.at(block).instructions) {
      if (instruction.op != Op::OpPhi) break;
      for (std::size_t i = 0; i + 1 < instruction.operands.size(); i += 2) {
        if (instruction.operands[i + 1] == from) phis.push_back(state_.valueOf(instruction.operands[i]));
      }
    }
    return phis;
  }

  // Both sides of a branch up to where they meet; the values there.
  Phis bothSides(std::uint32_t from, const SpirvInstruction& branch, const TraceNumber& condition, std::uint32_t join) {
    if (++nested_ > kMostNested) refuse("a loop whose end depends on data");
    const SpirvMemory before = state_.memory();
    Phis phis = side(from, branch.operands.at(1), join);
    const SpirvMemory memory_if_so = std::exchange(state_.memory(), before);
    const Phis otherwise = side(from, branch.operands.at(2), join);
    state_.joinMemory(condition, memory_if_so);
    for (std::size_t i = 0; i < phis.size(); ++i) {
      for (std::size_t j = 0; j < phis[i].size(); ++j) {
        phis[i][j] = state_.operations().selected(condition, phis[i][j], otherwise[i][j]);
      }
    }
    --nested_;
    return phis;
  }

  Phis side(std::uint32_t from, std::uint32_t to, std::uint32_t stop) {
    Phis phis = phisAt(to, from);
    return to == stop ? phis : flow(to, std::move(phis), stop);
  }

  // From the head of a block to that of `stop`; the values of the phis there.
  Phis flow(std::uint32_t label, Phis phis, std::uint32_t stop) {
    while (true) {
      if (++blocks_ > kMostBlocks) refuse("a loop without an end");
      const SpirvBlock& block = module_.blocks.at(label);
      for (std::size_t i = 0; i < phis.size(); ++i) state_.setValue(block.instructions[i], std::move(phis[i]));
      for (std::size_t i = phis.size(); i + 1 < block.instructions.size(); ++i) state_.execute(block.instructions[i]);
      const SpirvInstruction& end = block.instructions.back();
      const std::uint32_t from = std::exchange(label, kExit);
      if (end.op == Op::OpBranch) {
        label = end.operands.at(0);
        phis = phisAt(label, from);
      } else if (end.op == Op::OpBranchConditional || end.op == Op::OpSwitch) {
        const TraceNumber condition = state_.valueOf(end.operands.at(0)).at(0);
        if (!condition.known && end.op == Op::OpSwitch) refuse("a switch that depends on data");
        label = condition.known ? chosen(end, condition.value) : joins_.at(from);
        phis = condition.known ? phisAt(label, from) : bothSides(from, end, condition, label);
      } else if (end.op == Op::OpReturn) {
        phis = {};
      } else {
        refuse("a fragment is discarded");
      }
      if (label == stop) return phis;
      if (label == kExit) refuse("a return within a branch that depends on data");
    }
  }

  static std::uint32_t chosen(const SpirvInstruction& end, double value) {
    if (end.op == Op::OpBranchConditional) return end.operands.at(value != 0.0 ? 1 : 2);
    for (std::size_t i = 2; i + 1 < end.operands.size(); i += 2) {
      if (static_cast<double>(end.operands[i]) == value) return end.operands[i + 1];
    }
    return end.operands.at(1);
  }

  const SpirvModule& module_;
  const std::map<std::uint32_t, std::uint32_t> joins_;
  SpirvState state_;
  int blocks_ = 0;
  int nested_ = 0;
};

}  // namespace

std::vector<TraceOperation> traceShader(const SpirvModule& module) {
  return Tracer(module).trace();
}

}  // namespace welkin::study
