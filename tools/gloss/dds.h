// SPDX-License-Identifier: Apache-2.0
// A texture of blocks as a DDS file. Source: Microsoft, "DDS_HEADER" and "DDS_HEADER_DXT10".
#pragma once

#include <cstddef>
#include <vector>

#include "gloss/block_texture.h"

namespace welkin::gloss {

enum class BlockFormat {
  bc3,  ///< as the letters DXT5, which every reader knows
  bc4,  ///< by Direct3D 10's header, as bc5
  bc5
};

/// The bytes of the file: the mips, largest first. Width and height are mip 0's.
std::vector<std::byte> encodeBlockDds(BlockFormat format, int width, int height, const BlockTexture& texture);

}  // namespace welkin::gloss
