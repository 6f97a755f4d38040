// SPDX-License-Identifier: Apache-2.0
// A map as a Radiance picture (.hdr): a shared exponent, run-length encoded. Source: Ward, "Real Pixels", Graphics Gems
// II (1991); Radiance's "filefmts".
#pragma once

#include <cstddef>
#include <vector>

#include "maps/sky_map.h"

namespace welkin::maps {

struct RadianceFile {
  std::vector<std::byte> bytes;
  std::size_t saturated = 0;  ///< components past the largest number, 2^127 255/256, stored as that
};

/// Rounds every component to the nearest multiple of 2^-8 of the power of two above the texel's largest component. So
/// the error is at most 2^-8 of that component. Texels below 1e-38 become black.
RadianceFile encodeRadiance(const Map& map);

}  // namespace welkin::maps
