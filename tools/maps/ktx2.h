// SPDX-License-Identifier: Apache-2.0
// A cube as a KTX2 file, without supercompression. Sources: Khronos, "KTX File Format Specification" 2.0; "Khronos Data
// Format Specification" 1.3 for the descriptor.
#pragma once

#include <cstddef>
#include <vector>

#include "maps/encoded_cube.h"

namespace welkin::maps {

/// The bytes of the file. Its metadata are KTXorientation, "rd", and KTXwriter.
std::vector<std::byte> encodeKtx2(const EncodedCube& cube);

}  // namespace welkin::maps
