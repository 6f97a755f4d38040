// SPDX-License-Identifier: Apache-2.0
// Variables of a SPIR-V module and the pointers into them.
#pragma once

#include <cstdint>
#include <map>
#include <spirv/unified1/spirv.hpp11>
#include <vector>

#include "study/spirv_arithmetic.h"
#include "study/spirv_module.h"

namespace welkin::study {

/// Where numbers of a variable are.
struct SpirvPointer {
  std::uint32_t variable = 0;
  spv::StorageClass storage = {};
  std::uint32_t type = 0;                 ///< of what it points to
  int offset = 0;                         ///< in numbers, of the known indices
  int row = 0;                            ///< offset of the vector that it points into, or of itself
  std::vector<TraceNumber> data_indices;  ///< those that depend on data
};

/// The pointer to a part. Throws Error(internal) for an index past the end.
SpirvPointer partOf(const SpirvModule& module, const SpirvPointer& whole, const std::vector<TraceNumber>& indices);

/// For every number of what it points to, the offset of the vector that holds it, or its own.
std::vector<int> rowsOf(const SpirvModule& module, const SpirvPointer& pointer);

/// Whether the shader itself writes to the variable.
bool isPrivate(spv::StorageClass storage);

}  // namespace welkin::study
