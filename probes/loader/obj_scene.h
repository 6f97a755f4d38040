// SPDX-License-Identifier: Apache-2.0
// An OBJ file in a scene: read once, placed by any number of entries of level.toml.
#pragma once

#include "probes/level/geometry_source.h"

namespace welkin::loader {

/// Reads a .obj with the materials and images beside it. A material file or an image that is not there is a warning:
/// level.toml's albedo stands in. `builder` outlives what is returned. Throws Error.
std::unique_ptr<level::GeometrySource> readObjSource(const std::filesystem::path& path, level::SceneBuilder& builder);

}  // namespace welkin::loader
