// SPDX-License-Identifier: Apache-2.0
// Mips of cubemaps in formats that a device need not be able to write.
#pragma once

#include <cstdint>

#include "format/cubemap_format.h"

namespace welkin::vulkan {

/// Writes the mips after the first of a cubemap with `edge` texels along an edge to `mips`, one after the other, six
/// faces each. A texel is the mean of the texels that its square covers, in float. Those are texels of the first mip if
/// the edge is a power of two, else of the mip before. `mips` is only written to. False when memory runs out.
bool makeMips(format::CubemapFormat format, uint32_t edge, const unsigned char* texels, unsigned char* mips);

}  // namespace welkin::vulkan
