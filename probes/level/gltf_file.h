// SPDX-License-Identifier: Apache-2.0
// Opens a glTF 2.0 file as a tinygltf model, and says what is wrong with it.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>

namespace welkin::probes {

/// Reads .gltf or .glb with its buffers; images are left unread. Throws Error: `file` when it or a file that it names
/// cannot be read, `content` when it is cut, foreign, of another version, or asks for an extension.
tinygltf::Model readGltf(const std::filesystem::path& path);

}  // namespace welkin::probes
