// SPDX-License-Identifier: Apache-2.0
// A cube as a DDS file with the header of Direct3D 10. Source: Microsoft, "DDS file layout for cubic environment maps"
// and "DDS_HEADER_DXT10".
#pragma once

#include <cstddef>
#include <vector>

#include "maps/encoded_cube.h"

namespace welkin::maps {

/// The bytes of the file: face after face, each with its mips.
std::vector<std::byte> encodeDds(const EncodedCube& cube);

}  // namespace welkin::maps
