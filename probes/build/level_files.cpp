// SPDX-License-Identifier: Apache-2.0
#include "probes/build/level_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <welkin/welkin.hpp>

#include "format/container.h"
#include "format/domain_check.h"
#include "probes/build/level_bake.h"
#include "probes/build/merged_report.h"
#include "probes/geometry/sector_name.h"
#include "sky/bake/runtime_error.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"

namespace welkin::build {
namespace {

namespace fs = std::filesystem;
using sectors::LevelIndex;
using sectors::SectorEntry;

constexpr std::size_t kLargestIndex = std::size_t{256} << 20;
constexpr std::size_t kLargestSector = std::size_t{16} << 20;

bool isSame(const model::LightPath& path, const format::LightPath& file) {
  const auto same = [](const std::vector<double>& a, const flatbuffers::Vector<double>* b) {
    const auto values = format::spanOf(b);
    return std::equal(a.begin(), a.end(), values.begin(), values.end());
  };
  return path.latitude_rad == file.latitude_rad() && path.declination_rad == file.declination_rad() &&
         path.transit_h == file.transit_h() && path.north_offset_rad == file.north_offset_rad() &&
         same(path.key_time_h, file.key_time_h()) && same(path.key_azimuth_rad, file.key_azimuth_rad()) &&
         same(path.key_elevation_rad, file.key_elevation_rad());
}

/// Whether the sky has the paths that the sectors were baked along.
void checkPaths(const fs::path& sky_path, std::span<const std::byte> bytes, const LevelIndex& index) {
  if (index.sun != transfer::SunTransfer::directional) return;
  const format::Sky& sky = *format::openContainer(bytes).file->sky();
  const bool moon = index.moon_path.has_value();
  if (!index.sun_path || !isSame(*index.sun_path, *sky.sun()->path()) || moon != (sky.moon() != nullptr) ||
      (moon && !isSame(*index.moon_path, *sky.moon()->path())))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: its sun or moon has another path than the sectors were baked along; bake again",
                                  sky_path.string()));
}

/// The checked bytes of DIR/sky.welkin.
std::vector<std::byte> readSky(const fs::path& folder, const LevelIndex& index) {
  const fs::path path = folder / "sky.welkin";
  std::vector<std::byte> bytes = base::readFile(path);
  WelkinSky* sky = nullptr;
  WelkinMessage message{};
  const void* start = bytes.empty() ? &bytes : static_cast<const void*>(bytes.data());  // null is a fault of the caller
  const WelkinResult result = welkin_sky_open_memory(start, bytes.size(), &sky, &message);
  welkin_sky_close(sky);
  bake::require(result, path.string(), message.text);
  checkPaths(path, bytes, index);
  return bytes;
}

/// Parts by number, of shards that are `count`.
struct Parts {
  int count = 0;
  std::map<int, LevelIndex> part;
};

std::optional<Shard> shardOf(const fs::path& path) {
  static const std::regex kPart("level\\.([0-9]{1,7})-of-([0-9]{1,7})\\.welkin");
  std::smatch match;
  const std::string name = path.filename().string();
  if (!std::regex_match(name, match, kPart)) return std::nullopt;
  return Shard{std::stoi(match[1]), std::stoi(match[2])};
}

Parts readParts(const fs::path& folder) {
  Parts parts;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const auto shard = shardOf(entry.path());
    if (!shard) continue;
    if (parts.count != 0 && parts.count != shard->count)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: holds parts of {} and of {} shards; remove those of an earlier bake",
                                    folder.string(), parts.count, shard->count));
    parts.count = shard->count;
    parts.part.emplace(shard->index, readIndex(entry.path()));
  }
  if (error)
    throw base::Error(base::ExitStatus::file, fmt::format("{}: cannot read: {}", folder.string(), error.message()));
  if (parts.count == 0)
    throw base::Error(
        base::ExitStatus::file,
        fmt::format("{}: holds no part of a level, level.i-of-n.welkin; welkin bake LEVEL.toml -o {} --shard "
                    "i/n makes them",
                    folder.string(), folder.string()));
  for (int i = 0; i < parts.count; ++i)
    if (!parts.part.contains(i))
      throw base::Error(base::ExitStatus::file,
                        fmt::format("{}: shard {}/{} is missing: it was not baked, or not to its end", folder.string(),
                                    i, parts.count));
  return parts;
}

bool agree(const LevelIndex& a, const LevelIndex& b) {
  LevelIndex x = a;
  LevelIndex y = b;
  x.sector.clear();
  y.sector.clear();
  return sectors::encodeLevel(x) == sectors::encodeLevel(y);
}

}  // namespace

fs::path indexPath(const fs::path& folder) {
  return folder / "level.welkin";
}

fs::path partPath(const fs::path& folder, const Shard& shard) {
  return folder / fmt::format("level.{}-of-{}.welkin", shard.index, shard.count);
}

bool isLevelFolder(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder, error) && fs::exists(indexPath(folder), error);
}

LevelIndex readIndex(const fs::path& path) {
  return sectors::decodeLevel(base::readFile(path, kLargestIndex), path.string());
}

LevelIndex writeIndex(const fs::path& folder, LevelIndex index) {
  index.sky_checksum = base::hashOf(readSky(folder, index));
  base::writeFile(indexPath(folder), sectors::encodeLevel(index));
  return index;
}

void removeOtherSectors(const fs::path& folder, const LevelIndex& index) {
  static const std::regex kOurs("sector_(-?[0-9]+_-?[0-9]+)\\.welkin");
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "sectors", error)) {
    std::smatch match;
    const std::string name = entry.path().filename().string();
    if (!std::regex_match(name, match, kOurs)) continue;
    const auto known = [&](const SectorEntry& s) { return nameOf(s.id) == match[1].str(); };
    if (std::none_of(index.sector.begin(), index.sector.end(), known)) fs::remove(entry.path(), error);
  }
}

void removeTemporaries(const fs::path& folder, const std::vector<std::string>& skies) {
  static const std::regex kOurs(
      "((level|report|timing)(\\.[0-9]+-of-[0-9]+)?\\.(welkin|json)|sector_-?[0-9]+_-?[0-9]+\\.welkin)"
      "(\\.[0-9]+)?\\.tmp");
  static const std::regex kOfSky("(\\.(welkin|json)|_[0-9]{9}(_latlong)?\\.exr)(\\.[0-9]+)?\\.tmp");
  const auto isOurs = [&](const std::string& name) {
    return std::regex_match(name, kOurs) || std::any_of(skies.begin(), skies.end(), [&](const std::string& sky) {
             return name.starts_with(sky) && std::regex_match(name.substr(sky.size()), kOfSky);
           });
  };
  for (const fs::path& place : {folder, folder / "cubemaps", folder / "sectors"}) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(place, error))
      if (isOurs(entry.path().filename().string())) fs::remove(entry.path(), error);
  }
}

void removeParts(const fs::path& folder, std::optional<int> count) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const auto shard = shardOf(entry.path()); shard && shard->count != count) fs::remove(entry.path(), error);
}

void checkLevel(const fs::path& folder, const LevelIndex& index) {
  if (!index.sky_checksum)
    throw base::Error(base::ExitStatus::content, fmt::format("{}: is a shard's part and no index", folder.string()));
  if (base::hashOf(readSky(folder, index)) != *index.sky_checksum)
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{}: is not the sky that the level's index names; bake again", (folder / "sky.welkin").string()));
  for (const SectorEntry& s : index.sector) {
    const fs::path path = sectorPath(folder, s.id);
    const auto bytes = base::readFile(path, kLargestSector);
    const sectors::SectorFile file = sectors::decodeSector(bytes, path.string());
    if (file.id != s.id || base::hashOf(bytes) != s.checksum)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: is not the sector {} that the level's index names; bake again", path.string(),
                                    nameOf(s.id)));
  }
}

LevelIndex mergeParts(const fs::path& folder) {
  const base::FolderLock lock(folder);
  removeTemporaries(folder);
  const Parts parts = readParts(folder);
  LevelIndex index = parts.part.at(0);
  for (const auto& [i, part] : parts.part) {
    if (!agree(index, part))
      throw base::Error(
          base::ExitStatus::content,
          fmt::format("{}: shards 0/{} and {}/{} were baked of different levels or settings; bake them again",
                      folder.string(), parts.count, i, parts.count));
    if (i > 0) index.sector.insert(index.sector.end(), part.sector.begin(), part.sector.end());
  }
  std::sort(index.sector.begin(), index.sector.end(),
            [](const SectorEntry& a, const SectorEntry& b) { return a.id < b.id; });
  if (hashOf(index.sector) != index.all_sectors)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: the shards do not have every sector of the level just once", folder.string()));
  index.sky_checksum = base::hashOf(readSky(folder, index));
  checkLevel(folder, index);
  base::writeFile(indexPath(folder), sectors::encodeLevel(index));
  removeOtherSectors(folder, index);
  mergeReports(folder, parts.count, index);
  return index;
}

}  // namespace welkin::build
