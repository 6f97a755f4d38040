// SPDX-License-Identifier: Apache-2.0
// The straight program that is left of a shader when all that follows from constants is done: loops unrolled, arrays
// with known indices in registers, equal operations joined, operations that nothing needs dropped. Of a branch that
// depends on data both sides are in it, as a wave of diverging lanes runs them, with a selection for each number that
// differs.
#pragma once

#include <vector>

#include "study/spirv_module.h"
#include "study/trace_operations.h"

namespace welkin::study {

/// Follows the entry point. Throws Error(internal) for what it cannot follow: a loop whose end depends on data, a store
/// to an index that does, a discarded fragment.
std::vector<TraceOperation> traceShader(const SpirvModule& module);

}  // namespace welkin::study
