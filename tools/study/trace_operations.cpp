// SPDX-License-Identifier: Apache-2.0
#include "study/trace_operations.h"

namespace welkin::study {

TraceNumber TraceOperations::add(TraceOperation::Kind kind, const SpirvOperation& operation, TraceNumbers operands) {
  const auto [found, is_new] = indices_.try_emplace({operation, operands}, static_cast<int>(operations_.size()));
  if (is_new) operations_.push_back({kind, operation, std::move(operands), instruction_});
  return {false, 0.0, found->second};
}

TraceNumber TraceOperations::compute(const SpirvOperation& operation, TraceNumbers operands) {
  if (const auto value = simplified(operation, operands)) return *value;
  return add(TraceOperation::Kind::arithmetic, operation, std::move(operands));
}

TraceNumbers TraceOperations::partsOf(const TraceNumber& whole, int first, int count) {
  TraceNumbers parts;
  for (int i = first; i < first + count; ++i) {
    parts.push_back(
        add(TraceOperation::Kind::free, {spv::Op::OpCompositeExtract}, {whole, {true, static_cast<double>(i), 0}}));
  }
  return parts;
}

TraceNumber TraceOperations::selected(const TraceNumber& condition, const TraceNumber& yes, const TraceNumber& no) {
  return compute({spv::Op::OpSelect}, {condition, yes, no});
}

void TraceOperations::need(const TraceNumber& number) {
  if (number.known) return;
  TraceOperation& operation = operations_[static_cast<std::size_t>(number.operation)];
  if (std::exchange(operation.needed, true)) return;
  for (const TraceNumber& operand : operation.operands) need(operand);
}

}  // namespace welkin::study
