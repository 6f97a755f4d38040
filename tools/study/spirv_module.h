// SPDX-License-Identifier: Apache-2.0
// A SPIR-V module as instructions, types and the blocks of its entry point.
// The Khronos Group, "SPIR-V Specification", version 1.6, section 2.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <spirv/unified1/spirv.hpp11>
#include <vector>

namespace welkin::study {

struct SpirvInstruction {
  spv::Op op;
  std::uint32_t type = 0;    ///< 0 where it has none
  std::uint32_t result = 0;  ///< 0 where it has none
  std::vector<std::uint32_t> operands;
};

/// A type: how many numbers a value of it holds, and how they are reached.
struct SpirvType {
  spv::Op op;
  int numbers = 1;  ///< vectors, matrices, arrays and structures are flattened
  std::vector<std::uint32_t>
      parts;               ///< types of a structure's members; one for all elements or what a pointer points to
  bool is_signed = false;  ///< of an integer
};

/// Instructions from after a label to the one that ends the block.
struct SpirvBlock {
  std::uint32_t label;
  std::vector<SpirvInstruction> instructions;
};

struct SpirvModule {
  std::map<std::uint32_t, SpirvType> types;
  std::map<std::uint32_t, SpirvInstruction> globals;  ///< constants and variables outside functions, by result
  std::map<std::uint32_t, SpirvBlock> blocks;         ///< of the entry point, by label
  std::uint32_t first_block = 0;
  std::uint32_t math_library = 0;  ///< id of GLSL.std.450, or 0
};

/// Reads a module with one entry point, into which every function is inlined. Throws Error(internal) for other words.
SpirvModule readSpirv(std::span<const std::uint32_t> words);

}  // namespace welkin::study
