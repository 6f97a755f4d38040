// SPDX-License-Identifier: Apache-2.0
// A glTF file in a scene. It is read once and placed by any number of entries of level.toml.
#pragma once

#include "probes/level/geometry_source.h"

namespace welkin::gltf {

/// Reads a .gltf or .glb. `builder` must outlive the result. Throws Error, as place() does.
std::unique_ptr<level::GeometrySource> readGltfSource(const std::filesystem::path& path, level::SceneBuilder& builder);

}  // namespace welkin::gltf
