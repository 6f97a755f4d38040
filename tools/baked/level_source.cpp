// SPDX-License-Identifier: Apache-2.0
#include "baked/level_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "probes/build/merged_report.h"
#include "sky/bake/sky_file.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/hash.h"

namespace welkin::baked {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Why a file is not the one that was baked, or an empty text. A folder without a report does not tell.
std::string differenceOf(const fs::path& folder, const fs::path& file) {
  const std::optional<Json> report = build::earlierReport(folder);
  if (!report || !report->value("inputs", Json()).is_array()) return {};
  const std::vector<std::byte> bytes = base::readFile(file);
  const bake::Input own = bake::inputOf(file.filename().string(), file, bytes);
  const std::string checksum = base::textOf({own.xxh3_low, own.xxh3_high});
  const Json& inputs = (*report)["inputs"];
  const bool same = std::any_of(inputs.begin(), inputs.end(), [&](const Json& input) {
    return input.is_object() && input.contains("xxh3_128") && input["xxh3_128"] == checksum;
  });
  return same ? std::string()
              : fmt::format("{} is not as it was when {} was baked, or is another level: bake it anew", file.string(),
                            folder.string());
}

}  // namespace

LevelSource levelSource(const fs::path& folder, const fs::path& given) {
  if (!given.empty()) return {given, differenceOf(folder, given)};
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  const fs::path up = whole.has_filename() ? whole.parent_path() : whole.parent_path().parent_path();
  std::vector<fs::path> places;
  if (const std::optional<std::string> named = build::levelOfBake(folder)) places.push_back(folder / *named);
  places.insert(places.end(), {whole / "level.toml", up / "level.toml"});
  for (const fs::path& place : places)
    if (fs::is_regular_file(place, error)) return {place, differenceOf(folder, place)};
  std::string looked;
  for (const fs::path& place : places) looked += (looked.empty() ? "" : ", ") + place.string();
  throw base::Error(base::ExitStatus::file,
                    fmt::format("{} is a baked level, but its level.toml is not there ({}): --level names the file "
                                "that was baked",
                                folder.string(), looked));
}

}  // namespace welkin::baked
