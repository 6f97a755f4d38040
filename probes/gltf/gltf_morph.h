// SPDX-License-Identifier: Apache-2.0
// Morph targets of a glTF primitive, at weights that stay. glTF 2.0, 3.7.2.2.
#pragma once

#include <string>
#include <vector>

#include "probes/gltf/accessor.h"
#include "probes/level/mesh_piece.h"

namespace welkin::gltf {

/// Adds each target's positions, normals, colours and texture coordinates of set `uv_set`, times its weight. Normals
/// become unit again and colours stay within [0, 1]. A missing weight is 0. Attributes that the primitive itself lacks
/// are left out. `what` names the primitive. Throws Error(content) if a target has another number of vertices, or if
/// there are more weights than targets.
void addMorphTargets(const tinygltf::Primitive& primitive, const std::vector<double>& weights, int uv_set,
                     const AccessorReader& reader, const std::string& what, level::Attributes& attributes);

}  // namespace welkin::gltf
