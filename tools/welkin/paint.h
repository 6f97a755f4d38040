// SPDX-License-Identifier: Apache-2.0
// The generator of the starting gradients that `welkin init` writes and examples/island keeps: a tropical day.
#pragma once

#include <filesystem>

namespace welkin::tools {

enum class GradientSide { sun, anti };

/// Paints 96 x 32 texels from keys of colour over time and elevation and writes a 16-bit PNG, sRGB-encoded. The same
/// bytes on every machine. Throws Error(file).
void writeStartingGradient(GradientSide side, const std::filesystem::path& path);

}  // namespace welkin::tools
