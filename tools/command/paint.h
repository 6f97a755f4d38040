// SPDX-License-Identifier: Apache-2.0
// Paints the starting images of `welkin init`, a tropical day and its stars. examples/island uses the same gradients.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace welkin::command {

enum class GradientSide { sun, anti };

/// Paints 96 x 32 texels from keys of colour over time and elevation, and writes a 16-bit sRGB-encoded PNG. The file
/// has the same bytes on every machine. Throws Error(file).
void writeStartingGradient(GradientSide side, const std::filesystem::path& path);

/// Paints 1024 x 512 texels of stars and writes an 8-bit PNG; the same bytes on every machine. Throws Error(file).
void writeStartingStars(const std::filesystem::path& path);

/// Writes 16-bit sRGB-encoded RGB, rows from the top, as a PNG of 8 or 16 bits. Throws Error(file).
void writePaintedPng(const std::filesystem::path& path, int width, int height, int bits,
                     const std::vector<std::uint16_t>& rgb);

}  // namespace welkin::command
