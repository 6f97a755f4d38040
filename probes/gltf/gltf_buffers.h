// SPDX-License-Identifier: Apache-2.0
// The buffers of a glTF file, read before the model.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

namespace welkin::gltf {

using GltfBuffers = std::vector<std::vector<unsigned char>>;

/// A .gltf or .glb in its two parts. Throws Error(content) if a .glb is cut or has no JSON. glTF 2.0, 4.4.
struct GltfParts {
  std::string_view json;
  std::span<const std::byte> binary;  ///< the BIN chunk, or nothing
};
GltfParts partsOfGltf(std::span<const std::byte> bytes, const std::string& file);

/// Reads the buffers, and moves images in data URIs to bufferViews of buffers of their own. A buffer that has neither
/// a URI nor the file's BIN chunk is empty. `gltf` must have passed checkGltfTypes(). `files` gets the paths of files
/// that were read. Throws Error: `file` if a file cannot be read, `content` if a buffer is shorter than its byteLength.
GltfBuffers readGltfBuffers(nlohmann::json& gltf, std::span<const std::byte> binary, const std::filesystem::path& path,
                            std::vector<std::filesystem::path>& files);

/// Adds a buffer, with a bufferView of all its bytes. Returns the bufferView's index.
std::size_t addGltfBuffer(nlohmann::json& gltf, GltfBuffers& buffers, std::vector<unsigned char> bytes);

}  // namespace welkin::gltf
