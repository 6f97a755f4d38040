// SPDX-License-Identifier: Apache-2.0
// Reads the lights of KHR_lights_punctual.
#pragma once

#include <optional>
#include <string>

#include "probes/geometry/affine.h"
#include "probes/geometry/static_light.h"
#include "probes/gltf/accessor.h"

namespace welkin::gltf {

/// A light as its node places it, in candela, or lux for a directional light. It shines along the node's -z; a scale
/// changes neither its strength nor its range. Nothing where the transform leaves no direction to shine in. `what`
/// names the node in messages. Throws Error(content) for a value outside of the extension's range.
std::optional<geometry::StaticLight> readLight(const tinygltf::Light& light, const geometry::Affine& transform,
                                               const std::string& what, const AccessorReader& reader);

}  // namespace welkin::gltf
