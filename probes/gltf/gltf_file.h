// SPDX-License-Identifier: Apache-2.0
// Opens a glTF 2.0 file as a tinygltf model, with clear errors.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

namespace welkin::gltf {

/// Reads .gltf or .glb with its buffers. If an image is no buffer view, tinygltf::Image::image gets the encoded bytes
/// of its file. It stays empty if the file cannot be read; that is an error only when the image is used. `files` gets
/// the paths of all files read, and `warnings` a line for each extension that the file uses and that is neither read
/// nor harmless. Throws Error: `file` if it or a buffer that it names cannot be read; `content` if it is cut, foreign,
/// of another version, or requires an unknown extension.
tinygltf::Model readGltf(const std::filesystem::path& path, std::vector<std::filesystem::path>& files,
                         std::vector<std::string>& warnings);

}  // namespace welkin::gltf
