// SPDX-License-Identifier: Apache-2.0
// Primitives compressed by KHR_draco_mesh_compression, made plain.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "probes/gltf/gltf_buffers.h"

namespace welkin::gltf {

/// Decodes the positions, normals, colours, texture coordinates and indices of each compressed primitive into accessors
/// of their own, to which it then refers. `gltf` must have passed checkGltfTypes(). Throws Error(content) naming the
/// primitive if its bytes are not there, damaged, or lack an attribute.
void unpackDraco(nlohmann::json& gltf, GltfBuffers& buffers, const std::string& file);

}  // namespace welkin::gltf
