// SPDX-License-Identifier: Apache-2.0
// Which extensions of glTF are read, which change no diffuse light, and which a file uses beyond those.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace welkin::gltf {

/// Throws Error(content) naming the first of extensionsRequired that is neither read nor harmless. One that only gives
/// a texture another format may be required: such a texture is warned of where it is used.
void requireKnownExtensions(const nlohmann::json& gltf, const std::string& file);

/// One warning for each extension that is in the file's scene, in what its nodes use or in the file as a whole, and is
/// neither read nor harmless: its name, its first place and how many more there are. Extensions of textures are left
/// to who reads those. `gltf` must have passed checkGltfTypes().
std::vector<std::string> extensionWarnings(const nlohmann::json& gltf, const std::string& file);

}  // namespace welkin::gltf
