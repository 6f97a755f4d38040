// SPDX-License-Identifier: Apache-2.0
// Mips of cubemaps whose format no device need write.
#pragma once

#include <cstdint>

#include "format/cubemap_format.h"

namespace welkin::vulkan {

/// Writes the mips after the first of a cubemap of `edge` texels, each of six faces, one after the other, to `mips`. A
/// mip's texel is the mean of the first mip's over its square, in float; for an edge that is no power of two, over the
/// square that it covers, of the mip before. Only writes to `mips`. False when there is no memory.
bool makeMips(format::CubemapFormat format, uint32_t edge, const unsigned char* texels, unsigned char* mips);

}  // namespace welkin::vulkan
