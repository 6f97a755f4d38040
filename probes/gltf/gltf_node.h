// SPDX-License-Identifier: Apache-2.0
// Reads one node of a glTF model: its transform, role and light.
#pragma once

#include <optional>
#include <string>

#include "probes/gltf/accessor.h"
#include "probes/level/level_file.h"

namespace welkin::gltf {

/// The name of a node in messages.
std::string nodeName(int index, const tinygltf::Node& node);

/// The node's own transform, without its parents'. Throws Error(content).
geometry::Affine nodeTransform(int index, const tinygltf::Node& node, const AccessorReader& reader);

/// The role in extras.role; else vegetation if the entry's vegetation_nodes match; else the parent's. Throws
/// Error(content).
geometry::Role nodeRole(int index, const tinygltf::Node& node, const level::GeometryEntry& entry,
                        geometry::Role inherited, const AccessorReader& reader);

/// Whether the node itself is visible by KHR_node_visibility.
bool isVisible(const tinygltf::Node& node);

/// The node's light of KHR_lights_punctual; nullptr if it has none. Throws Error(content).
const tinygltf::Light* nodeLight(int index, const tinygltf::Node& node, const tinygltf::Model& model,
                                 const AccessorReader& reader);

}  // namespace welkin::gltf
