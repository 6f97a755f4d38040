// SPDX-License-Identifier: Apache-2.0
// Reads JSON of files: with a limit on its nesting, and by the form that it must have.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace welkin::base {

/// Most lists and objects within each other. The JSON library copies and prints by recursion.
inline constexpr int kDeepestJson = 64;

/// The value of a text. Nothing if the text is not JSON, or nests deeper than kDeepestJson.
std::optional<nlohmann::ordered_json> parseJson(std::string_view text);

/// Whether a value has the form of an example. An object has all members of the example, and may have others. A list
/// has items like the example's only one, or those of the example, or any where the example is empty. A whole number is
/// at least 0; a number with a fraction in the example stands for any number.
bool hasForm(const nlohmann::ordered_json& value, const nlohmann::ordered_json& example);

}  // namespace welkin::base
