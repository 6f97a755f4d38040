// SPDX-License-Identifier: Apache-2.0
// Buffer views compressed by EXT_meshopt_compression, made plain.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "probes/gltf/gltf_buffers.h"

namespace welkin::gltf {

/// Decodes each compressed bufferView into a buffer of its own, to which it then refers; the fallback buffer is not
/// read. `gltf` must have passed checkGltfTypes(). Throws Error(content) naming the bufferView if its bytes are not
/// there, damaged or of a mode or filter that the extension has not.
void unpackMeshopt(nlohmann::json& gltf, GltfBuffers& buffers, const std::string& file);

}  // namespace welkin::gltf
