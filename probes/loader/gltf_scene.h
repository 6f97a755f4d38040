// SPDX-License-Identifier: Apache-2.0
// A glTF file in a scene: read once, placed by any number of entries of level.toml.
#pragma once

#include "probes/level/geometry_source.h"

namespace welkin::loader {

/// Reads a .gltf or .glb. `builder` outlives what is returned. Throws Error, as placing does.
std::unique_ptr<level::GeometrySource> readGltfSource(const std::filesystem::path& path, level::SceneBuilder& builder);

}  // namespace welkin::loader
