// SPDX-License-Identifier: Apache-2.0
#include "probes/build/merged_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"

namespace welkin::build {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestReport = std::size_t{256} << 20;

fs::path pathOf(const fs::path& folder, const char* what, const std::optional<Shard>& shard) {
  return folder /
         (shard ? fmt::format("{}.{}-of-{}.json", what, shard->index, shard->count) : fmt::format("{}.json", what));
}

/// A list whose entries are objects, those of sectors with a name.
bool isListOf(const Json& report, const char* key, bool all_of_sectors) {
  if (!report.is_object() || !report.contains(key) || !report[key].is_array()) return false;
  return std::all_of(report[key].begin(), report[key].end(), [=](const Json& entry) {
    if (!entry.is_object()) return false;
    if (!entry.contains("sector")) return !all_of_sectors;
    return entry["sector"].is_string() && geometry::sectorOf(entry["sector"].get<std::string>()).has_value();
  });
}

Json readReport(const fs::path& path) {
  const auto bytes = base::readFile(path, kLargestReport);
  auto report = base::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!report || !isListOf(*report, "warnings", false) || !isListOf(*report, "sectors", true))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: is no report of a shard; bake it again", path.string()));
  return std::move(*report);
}

/// By sector, those of one in their order.
void sortBySector(Json& entries) {
  const auto sector = [](const Json& entry) { return *geometry::sectorOf(entry["sector"].get<std::string>()); };
  std::stable_sort(entries.begin(), entries.end(), [&](const Json& a, const Json& b) { return sector(a) < sector(b); });
}

/// Shard 0's has the sky's part, and all have the same warnings of the level as a whole.
Json merged(const std::vector<Json>& parts) {
  Json report = parts.front();
  Json warnings = Json::array();
  Json of_sectors = Json::array();
  Json sectors = Json::array();
  for (const Json& warning : report["warnings"])
    if (!warning.contains("sector")) warnings.push_back(warning);
  for (const Json& part : parts) {
    for (const Json& warning : part["warnings"])
      if (warning.contains("sector")) of_sectors.push_back(warning);
    for (const Json& sector : part["sectors"]) sectors.push_back(sector);
  }
  sortBySector(of_sectors);
  sortBySector(sectors);
  for (const Json& warning : of_sectors) warnings.push_back(warning);
  report["warnings"] = std::move(warnings);
  report["sectors"] = std::move(sectors);
  return report;
}

/// Whether these are the sectors of the index, in its order and with its checksums.
bool isOf(const Json& sectors, const sectors::LevelIndex& index) {
  return std::equal(sectors.begin(), sectors.end(), index.sector.begin(), index.sector.end(),
                    [](const Json& reported, const sectors::SectorEntry& s) {
                      return reported["sector"] == nameOf(s.id) && reported.contains("xxh3_128") &&
                             reported["xxh3_128"] == textOf(s.checksum);
                    });
}

/// An object; nothing where there is none that can be read.
std::optional<Json> objectIn(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  try {
    const auto bytes = base::readFile(path, kLargestReport);
    auto object = base::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!object || !object->is_object()) return std::nullopt;
    return object;
  } catch (const base::Error&) {
    return std::nullopt;  // it is about to be written anew
  }
}

std::optional<std::string> levelIn(const fs::path& timing) {
  const std::optional<Json> object = objectIn(timing);
  if (!object || !object->contains("level") || !(*object)["level"].is_string()) return std::nullopt;
  return (*object)["level"].get<std::string>();
}

}  // namespace

std::optional<Json> earlierReport(const fs::path& folder) {
  return objectIn(reportPath(folder, std::nullopt));
}

std::optional<std::string> levelOfBake(const fs::path& folder) {
  return levelIn(timingPath(folder, std::nullopt));
}

fs::path reportPath(const fs::path& folder, const std::optional<Shard>& shard) {
  return pathOf(folder, "report", shard);
}

fs::path timingPath(const fs::path& folder, const std::optional<Shard>& shard) {
  return pathOf(folder, "timing", shard);
}

void mergeReports(const fs::path& folder, int count, const sectors::LevelIndex& index) {
  std::error_code error;
  if (const std::optional<std::string> level = levelIn(timingPath(folder, Shard{0, count})))
    base::writeFile(timingPath(folder, std::nullopt), Json{{"level", *level}}.dump(2) + "\n");
  else
    fs::remove(timingPath(folder, std::nullopt), error);
  std::vector<Json> parts;
  for (int i = 0; i < count; ++i) {
    const fs::path path = reportPath(folder, Shard{i, count});
    if (!fs::exists(path, error)) {
      fs::remove(reportPath(folder, std::nullopt), error);
      return;
    }
    parts.push_back(readReport(path));
  }
  const Json report = merged(parts);
  if (isOf(report["sectors"], index))
    base::writeFile(reportPath(folder, std::nullopt), report.dump(2) + "\n");
  else
    fs::remove(reportPath(folder, std::nullopt), error);
}

}  // namespace welkin::build
