// SPDX-License-Identifier: Apache-2.0
// Reads numbers of a glTF extension's object, which tinygltf passes on unchecked.
#pragma once

#include <string>

#include "probes/gltf/accessor.h"

namespace welkin::gltf {

/// The object of an extension, or an empty one.
tinygltf::Value extensionOf(const tinygltf::ExtensionMap& extensions, const std::string& name);

/// Number `key` of `object`, or `otherwise` if it is missing. Throws Error(content) if it is not a number of magnitude
/// up to 1e9.
double numberIn(const tinygltf::Value& object, const std::string& key, double otherwise, const AccessorReader& reader,
                const std::string& what);

/// The same for element `i` of the array `key`, which has `size` elements.
double elementIn(const tinygltf::Value& object, const std::string& key, int i, int size, double otherwise,
                 const AccessorReader& reader, const std::string& what);

/// Index `key` of `object`, below `count`; -1 if it is missing.
int indexIn(const tinygltf::Value& object, const std::string& key, std::size_t count, const AccessorReader& reader,
            const std::string& what);

}  // namespace welkin::gltf
