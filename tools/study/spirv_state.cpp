// SPDX-License-Identifier: Apache-2.0
#include "study/spirv_state.h"

#include <fmt/format.h>
#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

using spv::Op;
using Kind = TraceOperation::Kind;

[[noreturn]] void refuse(std::string_view why) {
  throw base::Error(base::ExitStatus::internal, fmt::format("SPIR-V: {}", why));
}

bool isFetch(Op op) {
  return op >= Op::OpImageSampleImplicitLod && op <= Op::OpImageRead;
}

// Before the mask of the optional operands, which is no value.
std::size_t firstOperands(Op op) {
  switch (op) {
    case Op::OpImageSampleDrefImplicitLod:
    case Op::OpImageSampleDrefExplicitLod:
    case Op::OpImageSampleProjDrefImplicitLod:
    case Op::OpImageSampleProjDrefExplicitLod:
    case Op::OpImageGather:
    case Op::OpImageDrefGather:
      return 3;
    default:
      return 2;
  }
}

// Not calls, atomics and what else does more than compute a value.
bool canBeFollowed(const SpirvInstruction& instruction) {
  const Op op = instruction.op;
  return instruction.result != 0 &&
         (op == Op::OpExtInst || (op >= Op::OpVectorExtractDynamic && op <= Op::OpFwidthCoarse));
}

}  // namespace

SpirvState::SpirvState(const SpirvModule& module) : module_(module) {
  for (const auto& [id, global] : module.globals) addGlobal(id, global);
}

void SpirvState::setValue(const SpirvInstruction& phi, TraceNumbers numbers) {
  values_[phi.result] = std::move(numbers);
  types_of_values_[phi.result] = phi.type;
}

void SpirvState::needOutputs() {
  for (const auto& [variable, numbers] : memory_) {
    if (pointers_.at(variable).storage != spv::StorageClass::Output) continue;
    for (const TraceNumber& number : numbers) operations_.need(number);
  }
}

void SpirvState::joinMemory(const TraceNumber& condition, const SpirvMemory& yes) {
  for (auto& [variable, numbers] : memory_) {
    const auto there = yes.find(variable);
    if (there == yes.end()) continue;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = operations_.selected(condition, there->second[i], numbers[i]);
    }
  }
}

const SpirvType& SpirvState::typeOf(std::uint32_t id) const {
  return module_.types.at(id);
}

std::size_t SpirvState::count(std::uint32_t type) const {
  return static_cast<std::size_t>(typeOf(type).numbers);
}

void SpirvState::addGlobal(std::uint32_t id, const SpirvInstruction& global) {
  switch (global.op) {
    case Op::OpConstantTrue:
    case Op::OpConstantFalse:
      values_[id] = {{true, global.op == Op::OpConstantTrue ? 1.0 : 0.0, 0}};
      break;
    case Op::OpConstant: {
      const SpirvType& type = typeOf(global.type);
      const std::uint32_t bits = global.operands.at(0);
      const double value = type.op == Op::OpTypeFloat ? static_cast<double>(std::bit_cast<float>(bits))
                           : type.is_signed           ? static_cast<double>(std::bit_cast<std::int32_t>(bits))
                                                      : static_cast<double>(bits);
      values_[id] = {{true, value, 0}};
      break;
    }
    case Op::OpConstantComposite:
      values_[id] = joined(global.operands, 0);
      break;
    case Op::OpConstantNull:
    case Op::OpUndef:
      values_[id] = TraceNumbers(count(global.type));
      break;
    case Op::OpVariable:
      addVariable(global);
      break;
    default:
      refuse(fmt::format("a constant by instruction {}", static_cast<int>(global.op)));
  }
}

const TraceNumbers& SpirvState::valueOf(std::uint32_t id) {
  const auto found = values_.find(id);
  if (found != values_.end()) return found->second;
  const auto global = module_.globals.find(id);  // a constant that is made of one that comes later in the map
  if (global == module_.globals.end()) refuse(fmt::format("value {} is not there", id));
  addGlobal(id, global->second);
  return values_.at(id);
}

TraceNumbers SpirvState::joined(const std::vector<std::uint32_t>& ids, std::size_t from) {
  TraceNumbers numbers;
  for (std::size_t i = from; i < ids.size(); ++i) {
    const TraceNumbers& part = valueOf(ids[i]);
    numbers.insert(numbers.end(), part.begin(), part.end());
  }
  return numbers;
}

void SpirvState::addVariable(const SpirvInstruction& variable) {
  const auto storage = static_cast<spv::StorageClass>(variable.operands.at(0));
  const std::uint32_t type = typeOf(variable.type).parts.at(0);
  pointers_[variable.result] = {variable.result, storage, type, 0, 0, {}};
  if (!isPrivate(storage)) return;
  memory_[variable.result] = variable.operands.size() > 1 ? valueOf(variable.operands[1]) : TraceNumbers(count(type));
}

TraceNumbers SpirvState::load(const SpirvPointer& pointer) {
  if (isPrivate(pointer.storage)) {
    const TraceNumbers& all = memory_.at(pointer.variable);
    const int size = typeOf(pointer.type).numbers;
    const auto first = all.begin() + pointer.offset;
    if (pointer.data_indices.empty()) return {first, first + size};
    TraceNumbers operands = all;
    operands.insert(operands.end(), pointer.data_indices.begin(), pointer.data_indices.end());
    operands.push_back({true, static_cast<double>(pointer.offset), 0});
    return operations_.partsOf(operations_.add(Kind::arithmetic, {Op::OpLoad}, std::move(operands)), 0, size);
  }
  const bool buffer = pointer.storage == spv::StorageClass::Uniform ||
                      pointer.storage == spv::StorageClass::PushConstant ||
                      pointer.storage == spv::StorageClass::StorageBuffer;
  const std::vector<int> rows = rowsOf(module_, pointer);
  TraceNumbers numbers;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    TraceNumbers address = {{true, static_cast<double>(pointer.variable), 0}, {true, static_cast<double>(rows[i]), 0}};
    address.insert(address.end(), pointer.data_indices.begin(), pointer.data_indices.end());
    const TraceNumber row = operations_.add(buffer ? Kind::uniform_load : Kind::free, {Op::OpLoad}, std::move(address));
    numbers.push_back(operations_.partsOf(row, pointer.offset + static_cast<int>(i) - rows[i], 1)[0]);
  }
  return numbers;
}

void SpirvState::store(const SpirvPointer& pointer, const TraceNumbers& numbers) {
  if (!isPrivate(pointer.storage) || !pointer.data_indices.empty()) refuse("a store that depends on data");
  std::ranges::copy(numbers, memory_.at(pointer.variable).begin() + pointer.offset);
}

SpirvPointer SpirvState::literalPart(const std::vector<std::uint32_t>& operands, std::size_t whole) const {
  TraceNumbers indices;
  for (std::size_t i = whole + 1; i < operands.size(); ++i) {
    indices.push_back({true, static_cast<double>(operands[i]), 0});
  }
  const auto global = module_.globals.find(operands[whole]);
  const std::uint32_t type =
      global != module_.globals.end() ? global->second.type : types_of_values_.at(operands[whole]);
  return partOf(module_, {0, {}, type, 0, 0, {}}, indices);
}

TraceNumbers SpirvState::extracted(const SpirvInstruction& instruction) {
  const SpirvPointer part = literalPart(instruction.operands, 0);
  const auto first = valueOf(instruction.operands[0]).begin() + part.offset;
  return {first, first + typeOf(part.type).numbers};
}

TraceNumbers SpirvState::inserted(const SpirvInstruction& instruction) {
  TraceNumbers numbers = valueOf(instruction.operands.at(1));
  const SpirvPointer part = literalPart(instruction.operands, 1);
  std::ranges::copy(valueOf(instruction.operands[0]), numbers.begin() + part.offset);
  return numbers;
}

TraceNumbers SpirvState::shuffled(const SpirvInstruction& instruction) {
  const TraceNumbers both = joined({instruction.operands[0], instruction.operands[1]}, 0);
  TraceNumbers numbers;
  for (std::size_t i = 2; i < instruction.operands.size(); ++i) numbers.push_back(both.at(instruction.operands[i]));
  return numbers;
}

TraceNumbers SpirvState::computed(const SpirvInstruction& instruction) {
  const bool library = instruction.op == Op::OpExtInst;
  if (library && instruction.operands.at(0) != module_.math_library) refuse("a function of an unknown library");
  const SpirvOperation operation = {instruction.op, library ? instruction.operands.at(1) : 0};
  const std::vector<std::uint32_t> ids(instruction.operands.begin() + (library ? 2 : 0), instruction.operands.end());
  const int size = typeOf(instruction.type).numbers;
  if (isFetch(instruction.op)) {
    TraceNumbers operands;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const bool mask = i == firstOperands(instruction.op);
      const TraceNumbers part = mask ? TraceNumbers{{true, static_cast<double>(ids[i]), 0}} : valueOf(ids[i]);
      operands.insert(operands.end(), part.begin(), part.end());
    }
    return operations_.partsOf(operations_.add(Kind::fetch, operation, std::move(operands)), 0, size);
  }
  if (worksByComponent(operation)) {
    TraceNumbers numbers;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
      TraceNumbers operands;
      for (const std::uint32_t id : ids) operands.push_back(valueOf(id).at(valueOf(id).size() == 1 ? 0 : i));
      numbers.push_back(operations_.compute(operation, std::move(operands)));
    }
    return numbers;
  }
  if (instruction.op == Op::OpDot) {
    const TraceNumbers a = valueOf(ids.at(0));
    const TraceNumbers b = valueOf(ids.at(1));
    TraceNumber sum = operations_.compute({Op::OpFMul}, {a[0], b[0]});
    for (std::size_t i = 1; i < a.size(); ++i)
      sum = operations_.compute({Op::OpExtInst, GLSLstd450Fma}, {a[i], b[i], sum});
    return {sum};
  }
  const bool handle = instruction.op == Op::OpSampledImage || instruction.op == Op::OpImage;
  return operations_.partsOf(operations_.add(handle ? Kind::free : Kind::arithmetic, operation, joined(ids, 0)), 0,
                             size);
}

void SpirvState::execute(const SpirvInstruction& instruction) {
  operations_.beginInstruction();
  const std::vector<std::uint32_t>& operands = instruction.operands;
  if (instruction.result != 0) types_of_values_[instruction.result] = instruction.type;
  switch (instruction.op) {
    case Op::OpVariable:
      addVariable(instruction);
      break;
    case Op::OpAccessChain:
    case Op::OpInBoundsAccessChain:
      pointers_[instruction.result] = partOf(module_, pointers_.at(operands[0]), joined(operands, 1));
      break;
    case Op::OpLoad:
      values_[instruction.result] = load(pointers_.at(operands[0]));
      break;
    case Op::OpStore:
      store(pointers_.at(operands[0]), valueOf(operands[1]));
      break;
    case Op::OpCompositeConstruct:
      values_[instruction.result] = joined(operands, 0);
      break;
    case Op::OpCompositeExtract:
      values_[instruction.result] = extracted(instruction);
      break;
    case Op::OpCompositeInsert:
      values_[instruction.result] = inserted(instruction);
      break;
    case Op::OpVectorShuffle:
      values_[instruction.result] = shuffled(instruction);
      break;
    case Op::OpCopyObject:
      values_[instruction.result] = TraceNumbers(valueOf(operands[0]));
      break;
    case Op::OpUndef:
      values_[instruction.result] = TraceNumbers(count(instruction.type));
      break;
    case Op::OpSelectionMerge:
    case Op::OpLoopMerge:
    case Op::OpPhi:
      break;
    default:
      if (!canBeFollowed(instruction)) {
        refuse(fmt::format("instruction {} is not one that can be followed", static_cast<int>(instruction.op)));
      }
      values_[instruction.result] = computed(instruction);
  }
}

}  // namespace welkin::study
