// SPDX-License-Identifier: Apache-2.0
// BC6H blocks (BC6H_UF16): 4 x 4 texels of unsigned half floats in 16 bytes. Source: Microsoft, "BC6H format";
// Khronos Data Format Specification 1.3, "BPTC". Of its 14 modes this encoder uses the four with one pair of endpoints:
// a block has the colours of one line, in the logarithm-like scale of a half's bits. That suits a sky, whose colours
// change slowly. Its edges, such as the horizon, show more error than an encoder with two lines a block would leave.
#pragma once

#include <array>
#include <cstddef>

namespace welkin::maps {

inline constexpr int kBc6hSide = 4;
inline constexpr std::size_t kBc6hBytes = 16;

/// Linear RGB, row after row.
using Bc6hTexels = std::array<std::array<float, 3>, kBc6hSide * kBc6hSide>;

/// Writes the block of the texels to kBc6hBytes bytes at `block`. Components above 65504 become that, and negative ones
/// and NaN 0. Returns the number of components above. The same bits on every machine with IEEE arithmetic.
std::size_t encodeBc6h(const Bc6hTexels& texels, unsigned char* block);

}  // namespace welkin::maps
