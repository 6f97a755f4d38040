// SPDX-License-Identifier: Apache-2.0
#include "sky/base/json_text.h"

#include <algorithm>
#include <cstddef>

namespace welkin::base {
namespace {

using Json = nlohmann::ordered_json;

/// Whether the brackets outside of strings nest deeper than the limit. The answer for a text that is not JSON is of no
/// meaning, and of no harm: the library's parser does not recurse.
bool isTooDeep(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    switch (text[i]) {
      case '"':
        for (++i; i < text.size() && text[i] != '"'; ++i)
          if (text[i] == '\\') ++i;
        break;
      case '[':
      case '{':
        if (++depth > kDeepestJson) return true;
        break;
      case ']':
      case '}':
        --depth;
        break;
      default:
        break;
    }
  }
  return false;
}

}  // namespace

std::optional<Json> parseJson(std::string_view text) {
  if (isTooDeep(text)) return std::nullopt;
  Json value = Json::parse(text.begin(), text.end(), nullptr, false);
  if (value.is_discarded()) return std::nullopt;
  return value;
}

bool hasForm(const Json& value, const Json& example) {
  if (example.is_object())
    return value.is_object() && std::all_of(example.items().begin(), example.items().end(), [&](const auto& member) {
             const auto found = value.find(member.key());
             return found != value.end() && hasForm(*found, member.value());
           });
  if (example.is_array()) {
    if (!value.is_array()) return false;
    if (example.empty()) return true;
    if (example.size() == 1)
      return std::all_of(value.begin(), value.end(), [&](const Json& item) { return hasForm(item, example[0]); });
    return std::equal(value.begin(), value.end(), example.begin(), example.end(), hasForm);
  }
  if (example.is_number_float()) return value.is_number();
  if (example.is_number()) return value.is_number_unsigned();
  return value.type() == example.type();
}

}  // namespace welkin::base
