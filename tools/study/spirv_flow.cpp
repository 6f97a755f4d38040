// SPDX-License-Identifier: Apache-2.0
#include "study/spirv_flow.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace welkin::study {
namespace {

using Labels = std::set<std::uint32_t>;

std::vector<std::uint32_t> successorsOf(const SpirvBlock& block) {
  const SpirvInstruction& end = block.instructions.back();
  switch (end.op) {
    case spv::Op::OpBranch:
      return {end.operands.at(0)};
    case spv::Op::OpBranchConditional:
      return {end.operands.at(1), end.operands.at(2)};
    case spv::Op::OpSwitch: {
      std::vector<std::uint32_t> labels = {end.operands.at(1)};
      for (std::size_t i = 3; i < end.operands.size(); i += 2) labels.push_back(end.operands[i]);
      return labels;
    }
    default:
      return {kExit};
  }
}

}  // namespace

std::map<std::uint32_t, std::uint32_t> joinsOf(const SpirvModule& module) {
  Labels all = {kExit};
  for (const auto& [label, block] : module.blocks) all.insert(label);
  std::map<std::uint32_t, Labels> behind;  // what every path from the block goes through, itself included
  for (const std::uint32_t label : all) behind[label] = all;
  behind[kExit] = {kExit};
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [label, block] : module.blocks) {
      Labels common = all;
      for (const std::uint32_t successor : successorsOf(block)) {
        Labels both;
        std::ranges::set_intersection(common, behind.at(successor), std::inserter(both, both.end()));
        common = std::move(both);
      }
      common.insert(label);
      if (common != behind.at(label)) {
        behind[label] = std::move(common);
        changed = true;
      }
    }
  }
  // The nearest of them is the one that has the most behind it.
  std::map<std::uint32_t, std::uint32_t> joins;
  for (const auto& [label, block] : module.blocks) {
    std::uint32_t nearest = kExit;
    for (const std::uint32_t other : behind.at(label)) {
      if (other != label && behind.at(other).size() > behind.at(nearest).size()) nearest = other;
    }
    joins[label] = nearest;
  }
  return joins;
}

}  // namespace welkin::study
