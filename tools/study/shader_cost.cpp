// SPDX-License-Identifier: Apache-2.0
// Sections are numbered as in The Khronos Group, "SPIR-V Specification", version 1.6.
#define SPV_ENABLE_UTILITY_CODE
#include "study/shader_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <spirv/unified1/spirv.hpp11>
#include <string_view>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

#include "spirv/kDomeAnalytic.h"
#include "spirv/kDomeCubemaps.h"
#include "spirv/kIrradiance2.h"
#include "spirv/kIrradiance3.h"
#include "spirv/kIrradiance4.h"
#include "spirv/kIrradiance5.h"
#include "spirv/kModes4.h"
#include "spirv/kModes8.h"

using spv::Op;

struct StudyShader {
  const char* name;
  std::span<const std::uint32_t> spirv;
};

constexpr std::array<StudyShader, 8> kShaders = {{{"irradiance 2 bands", kIrradiance2},
                                                  {"irradiance 3 bands", kIrradiance3},
                                                  {"irradiance 4 bands", kIrradiance4},
                                                  {"irradiance 5 bands", kIrradiance5},
                                                  {"irradiance 4 modes", kModes4},
                                                  {"irradiance 8 modes", kModes8},
                                                  {"dome analytic", kDomeAnalytic},
                                                  {"dome cubemaps", kDomeCubemaps}}};

constexpr std::size_t kHeaderWords = 5;  // section 2.3

void require(bool holds, std::string_view otherwise) {
  if (!holds) throw base::Error(base::ExitStatus::internal, fmt::format("SPIR-V: {}", otherwise));
}

/// Sections 3.49.11 and 3.49.13 to 3.49.16 are one range of numbers: conversion, arithmetic, bits, relations, logic and
/// derivatives.
bool isArithmetic(Op op) {
  return op == Op::OpExtInst || (op >= Op::OpConvertFToU && op <= Op::OpFwidthCoarse && op != Op::OpBitcast);
}

bool isFetch(Op op) {
  return op >= Op::OpImageSampleImplicitLod && op <= Op::OpImageDrefGather;
}

/// Counts the instructions of a module in their order: types and variables come before their use.
class Counter {
 public:
  void add(Op op, std::span<const std::uint32_t> operands) {
    require(op != Op::OpLoopMerge, "a loop is not unrolled: its bounds depend on data");
    require(op != Op::OpFunctionCall, "a function is not inlined");
    bool has_result = false;
    bool has_type = false;
    spv::HasResultAndType(op, &has_result, &has_type);
    require(operands.size() >= 0U + has_result + has_type, "an instruction is cut");
    if (op == Op::OpTypeVector) components_[operands[0]] = static_cast<int>(operands[2]);
    if (op == Op::OpTypePointer)
      is_uniform_[operands[0]] = spv::StorageClass(operands[1]) == spv::StorageClass::Uniform;
    if (has_type && has_result) type_[operands[1]] = operands[0];
    if (isFetch(op)) ++cost_.texture_fetches;
    if (op == Op::OpLoad && is_uniform_[type_[operands[2]]]) ++cost_.uniform_loads;
    if (isArithmetic(op)) {
      ++cost_.instructions;
      cost_.scalar_operations += widestOf(operands, op == Op::OpExtInst ? 4 : 2);
    }
  }

  const ShaderCost& cost() const { return cost_; }

 private:
  int componentsOf(std::uint32_t type) const {
    const auto found = components_.find(type);
    return found == components_.end() ? 1 : found->second;
  }

  /// Components of the result or of an operand from `first` on, whichever are more.
  int widestOf(std::span<const std::uint32_t> operands, std::size_t first) const {
    int widest = componentsOf(operands[0]);
    for (std::size_t i = first; i < operands.size(); ++i)
      if (const auto type = type_.find(operands[i]); type != type_.end())
        widest = std::max(widest, componentsOf(type->second));
    return widest;
  }

  std::map<std::uint32_t, int> components_;      // by vector type; other types count as one
  std::map<std::uint32_t, bool> is_uniform_;     // by pointer type
  std::map<std::uint32_t, std::uint32_t> type_;  // by value
  ShaderCost cost_;
};

}  // namespace

ShaderCost countShader(std::span<const std::uint32_t> spirv) {
  require(spirv.size() > kHeaderWords && spirv[0] == spv::MagicNumber, "these words are no module");
  Counter counter;
  Op op = Op::OpNop;
  for (auto rest = spirv.subspan(kHeaderWords); !rest.empty();) {
    const std::size_t words = rest[0] >> spv::WordCountShift;
    require(words > 0 && words <= rest.size(), "an instruction is cut");
    op = static_cast<Op>(rest[0] & spv::OpCodeMask);
    counter.add(op, rest.subspan(1, words - 1));
    rest = rest.subspan(words);
  }
  require(op == Op::OpFunctionEnd, "the module is cut");
  return counter.cost();
}

std::vector<NamedShaderCost> measuredShaders() {
  std::vector<NamedShaderCost> costs;
  for (const StudyShader& shader : kShaders) costs.push_back({shader.name, countShader(shader.spirv)});
  return costs;
}

}  // namespace welkin::study
