// SPDX-License-Identifier: Apache-2.0
#include "study/spirv_memory.h"

#include <fmt/format.h>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

void addRows(const SpirvModule& module, std::uint32_t type_id, int offset, std::vector<int>& rows) {
  const SpirvType& type = module.types.at(type_id);
  if (type.op == spv::Op::OpTypeVector) {
    rows.insert(rows.end(), static_cast<std::size_t>(type.numbers), offset);
    return;
  }
  if (type.parts.empty()) {
    rows.push_back(offset);
    return;
  }
  const bool structure = type.op == spv::Op::OpTypeStruct;
  const int end = offset + type.numbers;
  for (std::size_t i = 0; offset < end; ++i) {
    const std::uint32_t part = type.parts[structure ? i : 0];
    addRows(module, part, offset, rows);
    offset += module.types.at(part).numbers;
  }
}

}  // namespace

SpirvPointer partOf(const SpirvModule& module, const SpirvPointer& whole, const std::vector<TraceNumber>& indices) {
  SpirvPointer part = whole;
  for (const TraceNumber& index : indices) {
    const SpirvType& type = module.types.at(part.type);
    const bool structure = type.op == spv::Op::OpTypeStruct;
    if (structure) {
      const auto member = static_cast<std::size_t>(index.value);
      if (!index.known || member >= type.parts.size())
        throw base::Error(base::ExitStatus::internal, "SPIR-V: a member does not exist");
      for (std::size_t i = 0; i < member; ++i) part.offset += module.types.at(type.parts[i]).numbers;
      part.type = type.parts[member];
    } else {
      if (type.parts.empty()) throw base::Error(base::ExitStatus::internal, "SPIR-V: an index into a single number");
      part.type = type.parts[0];
      const int size = module.types.at(part.type).numbers;
      if (!index.known) {
        part.data_indices.push_back(index);
      } else {
        const int element = static_cast<int>(index.value);
        const bool open = type.op == spv::Op::OpTypeRuntimeArray;
        if (element < 0 || (!open && element * size >= type.numbers)) {
          throw base::Error(base::ExitStatus::internal, fmt::format("SPIR-V: index {} is past the end", element));
        }
        part.offset += element * size;
      }
    }
    if (type.op != spv::Op::OpTypeVector) part.row = part.offset;
  }
  return part;
}

std::vector<int> rowsOf(const SpirvModule& module, const SpirvPointer& pointer) {
  const SpirvType& type = module.types.at(pointer.type);
  if (type.parts.empty()) return {pointer.row};
  std::vector<int> rows;
  addRows(module, pointer.type, pointer.offset, rows);
  return rows;
}

bool isPrivate(spv::StorageClass storage) {
  return storage == spv::StorageClass::Function || storage == spv::StorageClass::Private ||
         storage == spv::StorageClass::Output;
}

}  // namespace welkin::study
