// SPDX-License-Identifier: Apache-2.0
// Placings of a node's mesh by EXT_mesh_gpu_instancing.
#pragma once

#include <vector>

#include "probes/geometry/affine.h"
#include "probes/gltf/accessor.h"

namespace welkin::gltf {

/// Transforms of the node's instances, in the node's own axes: TRANSLATION, ROTATION and SCALE, of which each may be
/// missing. One identity without the extension. Throws Error(content).
std::vector<geometry::Affine> instancesOf(int index, const tinygltf::Node& node, const AccessorReader& reader);

}  // namespace welkin::gltf
