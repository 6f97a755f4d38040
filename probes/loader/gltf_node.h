// SPDX-License-Identifier: Apache-2.0
// What one node of a glTF model says: its transform, role and light.
#pragma once

#include <optional>
#include <string>

#include "probes/level/level_file.h"
#include "probes/loader/accessor.h"

namespace welkin::loader {

/// A node for messages.
std::string nodeName(int index, const tinygltf::Node& node);

/// Its own transform, parents left out. Throws Error(content).
geometry::Affine nodeTransform(int index, const tinygltf::Node& node, const AccessorReader& reader);

/// extras.role, else one of the entry's vegetation_nodes, else the parent's. Throws Error(content).
geometry::Role nodeRole(int index, const tinygltf::Node& node, const level::GeometryEntry& entry,
                        geometry::Role inherited, const AccessorReader& reader);

/// The light of KHR_lights_punctual that a node holds; nullptr: none. Throws Error(content).
const tinygltf::Light* nodeLight(int index, const tinygltf::Node& node, const tinygltf::Model& model,
                                 const AccessorReader& reader);

/// Radiant intensity, candela, of a light. Throws Error(content).
f64::Number3 lightIntensity(const tinygltf::Light& light, const std::string& what, const AccessorReader& reader);

}  // namespace welkin::loader
