// SPDX-License-Identifier: Apache-2.0
// Writes TIFF of 16 bits (TIFF revision 6.0, Aldus 1992).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace welkin::calibrate {

/// Width x height sRGB-encoded RGB texels, rows from the top, as the bytes of an uncompressed TIFF of one strip, least
/// byte first. The tags WhitePoint and PrimaryChromaticities tell Rec. 709's. At most 2^26 texels.
std::vector<std::byte> encodeTiff(int width, int height, std::span<const std::uint16_t> rgb);

}  // namespace welkin::calibrate
