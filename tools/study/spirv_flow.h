// SPDX-License-Identifier: Apache-2.0
// Where the paths from the blocks of an entry point meet again.
#pragma once

#include <cstdint>
#include <map>

#include "study/spirv_module.h"

namespace welkin::study {

/// Stands for the block after every return.
constexpr std::uint32_t kExit = 0;

/// For every block the first that all paths from it to the end go through: its immediate postdominator.
std::map<std::uint32_t, std::uint32_t> joinsOf(const SpirvModule& module);

}  // namespace welkin::study
