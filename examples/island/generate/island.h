// SPDX-License-Identifier: Apache-2.0
// The whole island.
#pragma once

#include "generate/scene.h"

namespace welkin::island {

/// The level as the files island.gltf and island.bin; always the same bytes.
GltfFiles islandFiles();

}  // namespace welkin::island
