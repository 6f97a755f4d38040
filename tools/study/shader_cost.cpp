// SPDX-License-Identifier: Apache-2.0
#include "study/shader_cost.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include "study/spirv_trace.h"

namespace welkin::study {
namespace {

#include "spirv/kDomeAnalytic.h"
#include "spirv/kDomeCubemaps.h"
#include "spirv/kEmpty.h"
#include "spirv/kIrradiance2.h"
#include "spirv/kIrradiance3.h"
#include "spirv/kIrradiance4.h"
#include "spirv/kIrradiance5.h"
#include "spirv/kModes4.h"
#include "spirv/kModes8.h"

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

// The numbers of a function of whole vectors are parts of one operation.
int scalarsOf(const std::vector<TraceOperation>& trace, std::size_t index, const std::vector<int>& parts) {
  return std::max({1, parts[index], parts[index] > 0 ? static_cast<int>(trace[index].operands.size()) : 0});
}

}  // namespace

ShaderCost countShader(std::span<const std::uint32_t> spirv) {
  const std::vector<TraceOperation> trace = traceShader(readSpirv(spirv));
  std::vector<int> parts(trace.size(), 0);
  for (const TraceOperation& operation : trace) {
    if (!operation.needed || operation.operation.op != spv::Op::OpCompositeExtract) continue;
    ++parts[static_cast<std::size_t>(operation.operands.at(0).operation)];
  }
  ShaderCost cost;
  std::set<int> instructions;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (!trace[i].needed) continue;
    switch (trace[i].kind) {
      case TraceOperation::Kind::arithmetic:
        instructions.insert(trace[i].instruction);
        cost.scalar_operations += scalarsOf(trace, i, parts);
        break;
      case TraceOperation::Kind::fetch:
        ++cost.texture_fetches;
        break;
      case TraceOperation::Kind::uniform_load:
        ++cost.uniform_loads;
        break;
      case TraceOperation::Kind::free:
        break;
    }
  }
  cost.instructions = static_cast<int>(instructions.size());
  return cost;
}

std::vector<NamedShaderCost> measuredShaders() {
  const ShaderCost empty = countShader(kEmpty);
  std::vector<NamedShaderCost> costs;
  for (const StudyShader& shader : kShaders) {
    ShaderCost cost = countShader(shader.spirv);
    cost.instructions -= empty.instructions;
    cost.scalar_operations -= empty.scalar_operations;
    cost.texture_fetches -= empty.texture_fetches;
    cost.uniform_loads -= empty.uniform_loads;
    costs.push_back({shader.name, cost});
  }
  return costs;
}

}  // namespace welkin::study
