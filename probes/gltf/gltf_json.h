// SPDX-License-Identifier: Apache-2.0
// Parses the JSON of a glTF file strictly: as deep as is allowed, each key once, every value that is read of its type.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace welkin::gltf {

/// Deepest nesting of arrays and objects. glTF needs about ten; `extras` may be deeper.
constexpr int kDeepestJson = 64;

/// Parses a text whose objects have each key once. `file` is named in messages. Throws Error(content) if the text is no
/// JSON, is no object, is nested deeper than kDeepestJson or has a key twice. The stack does not grow with the text.
nlohmann::json parseGltfJson(std::string_view text, const std::string& file);

/// Checks the type and the range of every value that the loader reads, and makes integers of whole numbers such as 1.0.
/// Indices are below 2^31, offsets and lengths below 2^53. Whether an index names a thing that is there is checked
/// where it is used. Throws Error(content) naming the key, its value, and the values that are allowed. Source: glTF
/// 2.0 specification, chapter 5, and the pages of the extensions.
void checkGltfTypes(nlohmann::json& gltf, const std::string& file);

}  // namespace welkin::gltf
