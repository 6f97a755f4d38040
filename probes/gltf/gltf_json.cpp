// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_json.h"

#include <fmt/format.h>

#include <set>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {

using Json = nlohmann::json;

Json parseGltfJson(std::string_view text, const std::string& file) {
  const auto refuse = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content,
                       fmt::format("{}: not a whole glTF file: {}", file, base::shortened(base::oneLine(why), 300)));
  };
  std::vector<std::set<std::string>> keys;  // of each object that is open
  const auto check = [&](int depth, Json::parse_event_t event, Json& value) {
    const bool opens = event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (opens && depth >= kDeepestJson)
      throw refuse(fmt::format("its JSON is nested deeper than {} arrays and objects", kDeepestJson));
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw refuse(fmt::format("an object of its JSON has the key \"{}\" twice",
                               base::shortened(value.get_ref<const std::string&>(), 60)));
    return true;
  };
  try {
    Json gltf = Json::parse(text, check);
    if (!gltf.is_object()) throw refuse("its JSON is no object");
    return gltf;
  } catch (const Json::exception& e) {
    const std::string_view why = e.what();  // begins with "[the library's name of the error] "
    const std::size_t end = why.find("] ");
    throw refuse(std::string(end == std::string_view::npos ? why : why.substr(end + 2)));
  }
}

}  // namespace welkin::gltf
