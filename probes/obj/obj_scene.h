// SPDX-License-Identifier: Apache-2.0
// An OBJ file in a scene. It is read once and placed by any number of entries of level.toml.
#pragma once

#include "probes/level/geometry_source.h"

namespace welkin::obj {

/// Reads a .obj with the materials and images beside it. A missing material file or image is a warning, and
/// level.toml's albedo takes its place. `builder` must outlive the result. Throws Error.
std::unique_ptr<level::GeometrySource> readObjSource(const std::filesystem::path& path, level::SceneBuilder& builder);

}  // namespace welkin::obj
