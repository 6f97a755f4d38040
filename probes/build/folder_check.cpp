// SPDX-License-Identifier: Apache-2.0
#include "probes/build/folder_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "probes/build/level_files.h"
#include "probes/build/merged_report.h"
#include "probes/geometry/sector_name.h"
#include "sky/bake/sky_record.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"

namespace welkin::build {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The level's part of a report may be about some of its sectors.
bool isOfIndex(const Json& sectors, const sectors::LevelIndex& index) {
  return std::all_of(sectors.begin(), sectors.end(), [&](const Json& reported) {
    return std::any_of(index.sector.begin(), index.sector.end(), [&](const sectors::SectorEntry& s) {
      return reported["sector"] == nameOf(s.id) && reported["xxh3_128"] == textOf(s.checksum) &&
             reported["bytes"] == s.bytes && reported["probes"] == s.probes;
    });
  });
}

/// The part of a report that is about a sky; null where it is about others.
Json partOf(const Json& report, const std::string& sky) {
  if (!report.contains("skies")) return sky == "sky" ? report : Json();
  return report["skies"].is_object() ? report["skies"].value(sky, Json()) : Json();
}

/// Compares a report with the records of the skies, by name, and with the index.
void checkReport(const fs::path& path, const std::map<std::string, Json>& made,
                 const std::optional<sectors::LevelIndex>& index) {
  constexpr std::size_t kLargest = std::size_t{256} << 20;
  const auto bytes = base::readFile(path, kLargest);
  const auto report = base::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const Json of_sector = {{"sector", ""}, {"bytes", 0}, {"probes", 0}, {"xxh3_128", ""}};
  if (!report || !base::hasForm(*report, {{"warnings", Json::array()}}) ||
      !base::hasForm(report->value("sectors", Json::array()), Json::array({of_sector})))
    throw base::Error(base::ExitStatus::content, fmt::format("{}: is no report; bake again", path.string()));
  for (const auto& [sky, record] : made) {
    const Json part = partOf(*report, sky);
    if (part.is_null()) continue;
    for (const auto& [key, value] : record.items())
      if (key != "warnings" && part.value(key, Json()) != value)
        throw base::Error(base::ExitStatus::content,
                          fmt::format("{}: \"{}\" is not that of {}.json: damaged, or of another bake; bake again",
                                      path.string(), key, sky));
  }
  if (index && !isOfIndex(report->value("sectors", Json::array()), *index))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: a sector is not that of level.welkin: damaged, or of another bake; bake again",
                                  path.string()));
}

}  // namespace

void checkFolder(const fs::path& folder) {
  std::map<std::string, Json> made;
  for (const std::string& sky : bake::recordedSkies(folder)) made[sky] = bake::checkedRecord(folder, sky);
  std::optional<sectors::LevelIndex> index;
  if (isLevelFolder(folder)) {
    index = readIndex(indexPath(folder));
    checkLevel(folder, *index);
  }
  const fs::path report = reportPath(folder, std::nullopt);
  std::error_code none;
  if (fs::exists(report, none)) checkReport(report, made, index);
}

}  // namespace welkin::build
