// SPDX-License-Identifier: Apache-2.0
// welkin calibrate --check: albedo of pictures, of a folder of them, of a model and of a level against limits.
#pragma once

#include <filesystem>
#include <vector>

#include "calibrate/albedo_check.h"

namespace welkin::command {

/// The albedo of a picture, of the pictures of a folder, or of the materials of a glTF or OBJ model or of a level.toml.
/// A material is named by its texture and one of the objects that have it. Texels count times the material's colour,
/// those that are cut away do not count, and without a texture the colours of its vertices stand for texels. Throws
/// Error(file) and Error(content).
std::vector<calibrate::CheckedAlbedo> checkedAlbedo(const std::filesystem::path& path, const calibrate::Gamut& gamut);

}  // namespace welkin::command
