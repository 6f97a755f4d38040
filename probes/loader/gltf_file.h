// SPDX-License-Identifier: Apache-2.0
// Opens a glTF 2.0 file as a tinygltf model, and says what is wrong with it.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <vector>

namespace welkin::loader {

/// Reads .gltf or .glb with its buffers. tinygltf::Image::image of an image that is no buffer view holds the bytes of
/// its file or data, still encoded; none where its file cannot be read, which is an error only where it is used.
/// `files` gets the paths of all that was read. Throws Error: `file` when it or a buffer that it names cannot be read,
/// `content` when it is cut, foreign, of another version, or requires an extension that is not known here.
tinygltf::Model readGltf(const std::filesystem::path& path, std::vector<std::filesystem::path>& files);

}  // namespace welkin::loader
