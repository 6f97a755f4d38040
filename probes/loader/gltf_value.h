// SPDX-License-Identifier: Apache-2.0
// Numbers of a glTF extension's object, which tinygltf hands on unchecked.
#pragma once

#include <string>

#include "probes/loader/accessor.h"

namespace welkin::loader {

/// The extension's object, or an empty one.
tinygltf::Value extensionOf(const tinygltf::ExtensionMap& extensions, const std::string& name);

/// Number `key` of `object`, or `otherwise`. Throws Error(content) for what is no number of magnitude up to 1e9.
double numberIn(const tinygltf::Value& object, const std::string& key, double otherwise, const AccessorReader& reader,
                const std::string& what);

/// The same of element `i` of the array `key`, which has `size` elements.
double elementIn(const tinygltf::Value& object, const std::string& key, int i, int size, double otherwise,
                 const AccessorReader& reader, const std::string& what);

/// Index `key` of `object`, below `count`; -1: there is none.
int indexIn(const tinygltf::Value& object, const std::string& key, std::size_t count, const AccessorReader& reader,
            const std::string& what);

}  // namespace welkin::loader
