// SPDX-License-Identifier: Apache-2.0
#include "probes/build/bake_sectors.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "probes/build/level_files.h"
#include "probes/build/sector_report.h"
#include "probes/build/sector_warnings.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;
using geometry::SectorId;

/// The sectors of a level that a bake is asked for.
std::vector<SectorId> wantedOf(const std::vector<SectorId>& all, const LevelOptions& options) {
  std::vector<SectorId> wanted = options.sectors.empty() ? all : options.sectors;
  if (!options.shard) return wanted;
  std::vector<SectorId> mine;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (i % static_cast<std::size_t>(options.shard->count) == static_cast<std::size_t>(options.shard->index))
      mine.push_back(wanted[i]);
  return mine;
}

/// Bakes sectors and tells how far it is.
class SectorBaker {
 public:
  SectorBaker(const LevelBake& level, const LevelOptions& options, base::Progress progress)
      : level_(level), options_(options), progress_(std::move(progress)) {}

  /// The sector's file, which is baked and written where it is out of date.
  SectorState bring(SectorId sector) {
    SectorState state = level_.state(options_.folder, sector);
    if (!state.stale.empty() || options_.force) {
      const base::Progress rays = progress_.stage(nameOf(sector), 0);
      state.file = readyFile(sector);
      if (!state.file) state.file = level_.bake(sector, rays);
      state.bytes = sectors::encodeSector(*state.file);
      base::writeFile(sectorPath(options_.folder, sector), state.bytes);
      rays_ += state.file->rays;
      ++baked_;
    }
    progress_.step();
    return state;
  }

  Json timing() const {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return {{"sectors_s", seconds},
            {"sectors_baked", baked_},
            {"rays", rays_},
            {"rays_per_s", seconds > 0.0 ? static_cast<double>(rays_) / seconds : 0.0}};
  }

 private:
  std::optional<sectors::SectorFile> readyFile(SectorId sector) const {
    const auto is = [&](const sectors::SectorFile& file) { return file.id == sector; };
    const auto found = std::find_if(options_.ready.begin(), options_.ready.end(), is);
    return found == options_.ready.end() ? std::nullopt : std::optional(*found);
  }

  const LevelBake& level_;
  const LevelOptions& options_;
  base::Progress progress_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::uint64_t rays_ = 0;
  std::size_t baked_ = 0;
};

/// The entries of all sectors; nothing when one that was not brought up to date now is out of date.
std::optional<std::vector<sectors::SectorEntry>> completed(const LevelBake& level, const LevelOptions& options,
                                                           const base::Progress& progress,
                                                           std::vector<sectors::SectorEntry> entries, Json& warnings) {
  constexpr std::size_t kNamed = 8;
  std::string stale;
  std::size_t count = 0;
  for (const SectorId sector : level.sectors()) {
    const auto is = [&](const sectors::SectorEntry& e) { return e.id == sector; };
    if (std::any_of(entries.begin(), entries.end(), is)) continue;
    progress.check();
    const SectorState state = level.state(options.folder, sector);
    if (state.stale.empty())
      entries.push_back(entryOf(*state.file, state.bytes));
    else if (++count <= kNamed)
      stale += (stale.empty() ? "" : ", ") + nameOf(sector);
  }
  if (count > 0) {
    warnings.push_back(
        {{"id", "no-index"},
         {"count", count},
         {"message", fmt::format("level.welkin was not written: out of date {} {}{}", count == 1 ? "is" : "are", stale,
                                 count > kNamed ? fmt::format(" and {} more", count - kNamed) : "")}});
    return std::nullopt;
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return entries;
}

/// Throws Error(file) where a sector's file has gone since it was found or written.
void requireFiles(const std::filesystem::path& folder, const std::vector<sectors::SectorEntry>& entries) {
  for (const auto& s : entries) base::requireSize(sectorPath(folder, s.id), s.bytes);
}

/// What every sector must be baked from, as shards must agree on.
base::Hash128 hashOfAll(const LevelBake& level, const LevelOptions& options, const base::Progress& progress) {
  std::vector<sectors::SectorEntry> entries;
  for (const SectorId sector : level.sectors()) {
    progress.check();
    entries.push_back({sector, 0, 0, {}, level.state(options.folder, sector).from.all});
  }
  return hashOf(entries);
}

}  // namespace

std::optional<sectors::LevelIndex> bakeSectors(const LevelBake& level, const LevelOptions& options,
                                               const base::Progress& progress, Json& report, Json& timing) {
  const auto wanted = wantedOf(level.sectors(), options);
  Json& warnings = report["warnings"];
  addWarnings(level, warnings);
  base::makeFolder(options.folder / "sectors");
  std::vector<sectors::SectorEntry> entries;
  Json sectors = Json::array();
  {
    SectorBaker baker(level, options, progress.stage("sectors", wanted.size()));
    for (const SectorId sector : wanted) {
      const SectorState state = baker.bring(sector);
      entries.push_back(entryOf(*state.file, state.bytes));
      sectors.push_back(reportJson(*state.file, entries.back()));
      addWarnings(*state.file, level.budget(), warnings);
    }
    timing.update(baker.timing());
  }
  report["sectors"] = std::move(sectors);
  std::size_t probes = 0;
  for (const sectors::SectorEntry& entry : entries) probes += entry.probes;
  if (entries.size() == level.sectors().size()) addProbelessWarning(entries.size(), probes, warnings);
  sectors::LevelIndex index = level.index();
  if (options.shard) {
    removeParts(options.folder, options.shard->count);
    requireFiles(options.folder, entries);
    index.sector = std::move(entries);
    index.all_sectors = hashOfAll(level, options, progress);
    base::writeFile(partPath(options.folder, *options.shard), sectors::encodeLevel(index));
    return std::nullopt;
  }
  auto all = completed(level, options, progress, std::move(entries), warnings);
  if (!all) return std::nullopt;
  requireFiles(options.folder, *all);
  index.sector = std::move(*all);
  index.all_sectors = hashOf(index.sector);
  index = writeIndex(options.folder, index);
  removeOtherSectors(options.folder, index);
  removeParts(options.folder, std::nullopt);
  return index;
}

}  // namespace welkin::build
