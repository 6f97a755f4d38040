// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "sky/bake/checked_file.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/hash.h"
#include "sky/base/json_text.h"

namespace welkin::bake {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestRecord = std::size_t{64} << 20;
const char* const kChecksum = "xxh3_128";

bool isThere(const fs::path& path) {
  std::error_code none;
  return fs::exists(path, none);
}

/// Null for a sky alone.
Json familyJson(const SkyFile& file) {
  Json inputs;
  for (const Input& input : file.family)
    inputs.push_back({{"name", input.name}, {kChecksum, base::textOf({input.xxh3_low, input.xxh3_high})}});
  return inputs;
}

Json requestJson(const SkyFile& file, Certify certify) {
  const BakeSettings& bake = file.bake;
  Json json = {{"method", kSkyBakeVersion},
               {"max_error", bake.max_error ? Json(*bake.max_error) : Json()},
               {"cubemap_error", bake.cubemap_error ? Json(*bake.cubemap_error) : Json()},
               {"target", bake.target.name},
               {"certify", nameOf(certify)},
               {"cubemaps", !(bake.fixed.cubemaps && bake.cubemap_time_h.empty())}};  // a level may need none
  if (Json family = familyJson(file); !family.is_null()) json["family"] = std::move(family);
  return json;
}

/// A file's name may hold bytes that are no UTF-8, which JSON does not allow.
std::string textOf(const Json& record, int indent) {
  return record.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string checksumOf(Json record) {
  record.erase(kChecksum);
  const std::string text = textOf(record, -1);
  return base::textOf(base::hashOf(std::as_bytes(std::span(text))));
}

/// Whether `made` has all that reports, plans and comparisons take from it.
bool isMade(const std::string& sky, const Json& made, const Json& request) {
  Json form = {
      {"table", {{"name", ""}, {"channels", 0}, {"encoding", ""}, {"keys", 0}, {"quadrature", ""}, {"bytes", 0}}},
      {"cubemaps", {{"count", 0}, {"size", 0}, {"format", ""}, {"bytes", 0}}},
      {"gradients", {{"format", ""}, {"bytes", 0}}},
      {"left_out", Json::array({{{"what", ""}, {"why", ""}, {"bytes", 0}}})},
      {"outputs", Json::array({{{"file", ""}, {"bytes", 0}, {kChecksum, ""}}})},
      {"warnings", Json::array({{{"id", ""}, {"message", ""}}})}};
  if (!request.value("max_error", Json()).is_null()) form["table"]["predicted_error"] = 0.0;
  if (request.value("certify", "") != nameOf(Certify::none) || made.contains("certificate"))
    form["certificate"] = {{"max_error", 0.0},
                           {"time_h", 0.0},
                           {"normal", {0.0, 0.0, 0.0}},
                           {"channel", ""},
                           {"mean_error", 0.0},
                           {"parts", {{"quadrature", 0.0}, {"truncation", 0.0}, {"time", 0.0}, {"encoding", 0.0}}}};
  if (made.contains("certificate") && made["certificate"].contains("cubemaps"))
    form["certificate"]["cubemaps"] = {{"max_error", 0.0}};
  static const std::regex kCubemaps("_[0-9]{9}(_latlong)?\\.exr");
  const std::string cubemaps = "cubemaps/" + sky;
  return base::hasForm(made, form) && std::all_of(made["outputs"].begin(), made["outputs"].end(), [&](const Json& o) {
           const std::string name = o["file"];
           return name == sky + ".welkin" ||
                  (name.starts_with(cubemaps) && std::regex_match(name.substr(cubemaps.size()), kCubemaps));
         });
}

/// Null where it is not a whole record.
Json readRecord(const fs::path& path) {
  const auto bytes = base::readFile(path, kLargestRecord);
  auto record = base::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!record || !base::hasForm(*record, {{kChecksum, ""}, {"request", Json::object()}, {"made", Json::object()}}))
    return {};
  return (*record)[kChecksum] == checksumOf(*record) ? std::move(*record) : Json();
}

/// Names in a list, each once.
class Names {
 public:
  void add(const std::string& name) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  }
  std::string text() const {
    std::string text;
    for (const std::string& name : names_) text += (text.empty() ? "" : ", ") + name;
    return text;
  }

 private:
  std::vector<std::string> names_;
};

/// Inputs that are in one list and, with this content and in this place, not in the other.
void addChanged(const std::vector<Input>& now, const flatbuffers::Vector<flatbuffers::Offset<format::Input>>* then,
                Names& changed) {
  const std::size_t there = then != nullptr ? then->size() : 0;
  for (std::size_t i = 0; i < std::max(now.size(), there); ++i) {
    const format::Input* old = i < there ? then->Get(static_cast<flatbuffers::uoffset_t>(i)) : nullptr;
    const std::string old_name = old != nullptr && old->name() != nullptr ? old->name()->str() : "";
    if (i < now.size() && old != nullptr && now[i].name == old_name && now[i].xxh3_low == old->xxh3_low() &&
        now[i].xxh3_high == old->xxh3_high())
      continue;
    if (i < now.size()) changed.add(now[i].name);
    if (old != nullptr) changed.add(old_name);
  }
}

/// How the outputs that are there differ from those of the record.
std::string differenceOf(const fs::path& folder, const Json& outputs) {
  Names missing, changed;
  std::error_code none;
  for (const Json& output : outputs) {
    const std::string name = output["file"];
    if (!isThere(folder / name))
      missing.add(name);
    else if (fs::file_size(folder / name, none) != output["bytes"].get<std::uintmax_t>() ||
             base::textOf(base::hashOf(base::readFile(folder / name))) != output[kChecksum])
      changed.add(name);
  }
  if (!missing.text().empty()) return "missing: " + missing.text();
  return changed.text().empty() ? "" : "changed: " + changed.text();
}

format::Fault noSky(const format::File& file) {
  return file.sky() != nullptr ? format::Fault{} : format::Fault{"sky", "must be there"};
}

}  // namespace

SkyState skyState(const fs::path& folder, const SkyFile& file, Certify certify) {
  const std::string record_name = file.name + ".json";
  const fs::path baked = folder / (file.name + ".welkin");
  if (folder.empty() || !isThere(baked)) return {"missing", {}};
  Names changed;
  try {
    const auto bytes = base::readFile(baked);
    addChanged(file.inputs, openChecked(bytes, "it", format::Kind::sky, noSky).inputs(), changed);
  } catch (const base::Error& e) {
    if (e.status() != base::ExitStatus::content) throw;
    return {std::string("unreadable: ") + e.what(), {}};
  }
  if (!isThere(folder / record_name)) return {"missing: " + record_name, {}};
  Json record = readRecord(folder / record_name);
  if (record.is_null()) return {"unreadable: " + record_name, {}};
  const Json request = requestJson(file, certify);
  for (const auto& [key, value] : request.items())
    if (record["request"].value(key, Json("")) != value) changed.add(key);
  if (record["request"].contains("family") && !request.contains("family")) changed.add("family");
  if (!changed.text().empty()) return {"changed: " + changed.text(), {}};
  if (!isMade(file.name, record["made"], request)) return {"unreadable: " + record_name, {}};
  std::string difference = differenceOf(folder, record["made"]["outputs"]);
  if (!difference.empty()) return {std::move(difference), {}};
  return {"", std::move(record["made"])};
}

Json checkedRecord(const fs::path& folder, const std::string& sky) {
  const std::string name = sky + ".json";
  const fs::path path = folder / name;
  if (!isThere(path)) return {};
  Json record = readRecord(path);
  if (record.is_null() || !isMade(sky, record["made"], record["request"]))
    throw base::Error(base::ExitStatus::content, path.string() + ": is damaged or was edited; bake again");
  const std::string difference = differenceOf(folder, record["made"]["outputs"]);
  if (!difference.empty())
    throw base::Error(difference.starts_with("missing") ? base::ExitStatus::file : base::ExitStatus::content,
                      fmt::format("{}: outputs that {} lists are {}; bake again", folder.string(), name, difference));
  return std::move(record["made"]);
}

std::vector<std::string> recordedSkies(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".welkin" && isThere(fs::path(path).replace_extension(".json")))
      names.push_back(path.stem().string());
  }
  if (isThere(folder / "sky.json") && std::find(names.begin(), names.end(), "sky") == names.end())
    names.emplace_back("sky");
  std::sort(names.begin(), names.end());
  return names;
}

std::string recordText(const SkyFile& file, Certify certify, const Json& made) {
  Json record = {{"request", requestJson(file, certify)}, {"made", made}};
  record[kChecksum] = checksumOf(record);
  return textOf(record, 2) + "\n";
}

}  // namespace welkin::bake
