// SPDX-License-Identifier: Apache-2.0
#define SPV_ENABLE_UTILITY_CODE
#include "study/spirv_module.h"

#include <fmt/format.h>

#include <string_view>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

[[noreturn]] void refuse(std::string_view why) {
  throw base::Error(base::ExitStatus::internal, fmt::format("SPIR-V: {}", why));
}

constexpr std::size_t kHeaderWords = 5;

SpirvInstruction readInstruction(std::span<const std::uint32_t> words) {
  SpirvInstruction instruction = {static_cast<spv::Op>(words[0] & spv::OpCodeMask), 0, 0, {}};
  bool has_result = false;
  bool has_type = false;
  spv::HasResultAndType(instruction.op, &has_result, &has_type);
  std::size_t at = 1;
  if (words.size() < 1U + has_result + has_type) refuse("an instruction is cut");
  if (has_type) instruction.type = words[at++];
  if (has_result) instruction.result = words[at++];
  instruction.operands.assign(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
  return instruction;
}

const SpirvType& typeAt(const SpirvModule& module, std::uint32_t id) {
  const auto found = module.types.find(id);
  if (found == module.types.end()) refuse(fmt::format("type {} is not declared before its use", id));
  return found->second;
}

void addType(SpirvModule& module, const SpirvInstruction& instruction) {
  SpirvType type = {.op = instruction.op, .parts = {}};
  const std::vector<std::uint32_t>& operands = instruction.operands;
  switch (instruction.op) {
    case spv::Op::OpTypeInt:
    case spv::Op::OpTypeFloat:
      if (operands.at(0) != 32) refuse("numbers of another width than 32 bits");
      type.is_signed = instruction.op == spv::Op::OpTypeInt && operands.at(1) != 0;
      break;
    case spv::Op::OpTypeVector:
    case spv::Op::OpTypeMatrix:
      type.parts = {operands.at(0)};
      type.numbers = static_cast<int>(operands.at(1)) * typeAt(module, operands[0]).numbers;
      break;
    case spv::Op::OpTypeArray: {
      const auto length = module.globals.find(operands.at(1));
      if (length == module.globals.end()) refuse("the length of an array is not known");
      type.parts = {operands[0]};
      type.numbers = static_cast<int>(length->second.operands.at(0)) * typeAt(module, operands[0]).numbers;
      break;
    }
    case spv::Op::OpTypeStruct:
      type.parts = operands;
      type.numbers = 0;
      for (const std::uint32_t part : operands) type.numbers += typeAt(module, part).numbers;
      break;
    case spv::Op::OpTypePointer:
      type.parts = {operands.at(1)};
      break;
    case spv::Op::OpTypeRuntimeArray:
      type.parts = {operands.at(0)};
      break;
    default:
      break;
  }
  module.types[instruction.result] = std::move(type);
}

}  // namespace

SpirvModule readSpirv(std::span<const std::uint32_t> words) {
  if (words.size() < kHeaderWords || words[0] != spv::MagicNumber)
    refuse("no module: the first word is not the magic number");
  SpirvModule module;
  SpirvBlock* block = nullptr;
  int functions = 0;
  for (std::size_t at = kHeaderWords; at < words.size();) {
    const std::size_t count = words[at] >> spv::WordCountShift;
    if (count == 0 || at + count > words.size()) refuse("an instruction is cut");
    const SpirvInstruction instruction = readInstruction(words.subspan(at, count));
    at += count;
    switch (instruction.op) {
      case spv::Op::OpExtInstImport:
        module.math_library = instruction.result;
        break;
      case spv::Op::OpFunction:
        if (++functions > 1) refuse("a function is not inlined into the entry point");
        break;
      case spv::Op::OpLabel:
        block = &module.blocks[instruction.result];
        block->label = instruction.result;
        if (module.first_block == 0) module.first_block = instruction.result;
        break;
      case spv::Op::OpFunctionEnd:
        block = nullptr;
        break;
      default:
        if (block != nullptr) {
          block->instructions.push_back(instruction);
        } else if (instruction.op >= spv::Op::OpTypeVoid && instruction.op <= spv::Op::OpTypeFunction) {
          addType(module, instruction);
        } else if (instruction.result != 0 && instruction.type != 0) {
          module.globals[instruction.result] = instruction;
        }
    }
  }
  if (functions == 0 || module.first_block == 0) refuse("no entry point");
  return module;
}

}  // namespace welkin::study
