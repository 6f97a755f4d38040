// SPDX-License-Identifier: Apache-2.0
#include "view/settings.h"

#include <nlohmann/json.hpp>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "view/session.h"

namespace welkin::view {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSettingsFile = "view.json";
constexpr std::size_t kLargestSettings = std::size_t{1} << 16;

std::optional<double> numberIn(const Json& json, const char* key, double low, double high) {
  if (!json.contains(key) || !json[key].is_number()) return std::nullopt;
  const double value = json[key].get<double>();
  return value >= low && value <= high ? std::optional(value) : std::nullopt;
}

template <typename T>
void readNumber(const Json& json, const char* key, double low, double high, T& value) {
  if (const std::optional<double> number = numberIn(json, key, low, high)) value = static_cast<T>(*number);
}

}  // namespace

Settings readSettings(const std::filesystem::path& folder) {
  Settings settings;
  std::error_code error;
  if (folder.empty() || !std::filesystem::is_regular_file(folder / kSettingsFile, error)) return settings;
  try {
    const std::vector<std::byte> bytes = base::readFile(folder / kSettingsFile, kLargestSettings);
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    const auto json = Json::parse(text, text + bytes.size(), nullptr, false);
    if (!json.is_object()) return settings;
    readNumber(json, "width", 64, 16384, settings.width);
    readNumber(json, "height", 64, 16384, settings.height);
    settings.exposure_ev = numberIn(json, "exposure", -40.0, 40.0);
    if (json.contains("bounds") && json["bounds"].is_boolean()) settings.bounds = json["bounds"].get<bool>();
    readNumber(json, "truth_paths", 1, 1 << 24, settings.truth_paths);
    readNumber(json, "pixel_paths", 1, 4096, settings.pixel_paths);
  } catch (const base::Error&) {  // settings are a convenience: what cannot be read is not kept
  }
  return settings;
}

void writeSettings(const std::filesystem::path& folder, const Settings& settings) {
  if (folder.empty()) return;
  const Json json = {{"width", settings.width},
                     {"height", settings.height},
                     {"exposure", settings.exposure_ev ? Json(*settings.exposure_ev) : Json(nullptr)},
                     {"bounds", settings.bounds},
                     {"truth_paths", settings.truth_paths},
                     {"pixel_paths", settings.pixel_paths}};
  try {
    base::makeFolder(folder);
    base::writeFile(folder / kSettingsFile, json.dump(2) + "\n");
  } catch (const base::Error&) {
  }
}

Settings settingsOf(const Session& session) {
  const State& s = session.state();
  return {session.width(), session.height(), s.exposure_ev, s.bounds, s.truth_paths, s.pixel_paths};
}

void apply(const Settings& settings, State& state) {
  state.exposure_ev = settings.exposure_ev;
  state.bounds = settings.bounds;
  state.truth_paths = settings.truth_paths;
  state.pixel_paths = settings.pixel_paths;
}

}  // namespace welkin::view
