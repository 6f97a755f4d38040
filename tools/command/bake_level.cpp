// SPDX-License-Identifier: Apache-2.0
#include "command/bake_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "command/level_files.h"
#include "command/sector_report.h"
#include "probes/geometry/sector_name.h"
#include "probes/loader/surfaces_of.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

using Json = nlohmann::ordered_json;
using build::SectorState;
using geometry::SectorId;
using sectors::SectorFile;
using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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

/// Bakes sectors and shows how far it is.
class SectorBaker {
 public:
  SectorBaker(const LevelInput& level, const LevelOptions& options, ProgressReport::Style style, std::size_t sectors)
      : level_(level), options_(options), progress_(style, "sectors", sectors) {}

  /// The sector's file, which is baked and written where it is out of date.
  SectorState bring(SectorId sector) {
    SectorState state = level_.bake.state(options_.folder, sector);
    if (!state.stale.empty() || options_.force) {
      state.file = level_.bake.bake(sector, [&](std::uint64_t rays) { return advance(sector, rays); });
      state.bytes = sectors::encodeSector(*state.file);
      base::writeFile(build::sectorPath(options_.folder, sector), state.bytes);
      ++baked_;
    }
    progress_.step();
    endIfInterrupted();
    return state;
  }

  Json timing() const {
    const double seconds = secondsSince(start_);
    return {{"sectors_s", seconds},
            {"sectors_baked", baked_},
            {"rays", rays_.load()},
            {"rays_per_s", seconds > 0.0 ? static_cast<double>(rays_) / seconds : 0.0}};
  }

 private:
  bool advance(SectorId sector, std::uint64_t rays) {
    if (rays == 0) return progress_.step(0);
    rays_ += rays;
    const double per_s = static_cast<double>(rays_) / std::max(secondsSince(start_), 1e-9);
    progress_.note(fmt::format("sector {}, {:.2f} Mrays/s", nameOf(sector), 1e-6 * per_s),
                   {{"sector", nameOf(sector)}, {"rays_per_s", std::llround(per_s)}});
    return progress_.step(0);
  }

  const LevelInput& level_;
  const LevelOptions& options_;
  ProgressReport progress_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::uint64_t> rays_ = 0;
  std::size_t baked_ = 0;
};

/// The first places of some kinds, or of those the ones by hand, and how many more there are.
std::string placesOf(const placement::PlacementCounts& placement,
                     std::initializer_list<placement::NamedPlace::Kind> kinds, bool by_hand, std::size_t count) {
  const std::size_t most = by_hand ? placement::kMostNamedByHand : placement::kMostNamed;
  std::string text;
  std::size_t named = 0;
  for (const placement::NamedPlace& n : placement.named) {
    if ((by_hand && !n.by_hand) || named == most || std::find(kinds.begin(), kinds.end(), n.kind) == kinds.end())
      continue;
    const auto& p = n.position;
    text += named++ > 0 ? ", " : "";
    text +=
        n.by_hand ? fmt::format("[{}, {}, {}]", p.x, p.y, p.z) : fmt::format("[{:.2f}, {:.2f}, {:.2f}]", p.x, p.y, p.z);
    if (n.moved_m > 0.0) text += fmt::format(" by {:.2f} m", n.moved_m);
  }
  if (named == 0) return fmt::format("{} that are not named", count);
  return count > named ? fmt::format("{} and {} more", text, count - named) : text;
}

void addWarnings(const SectorFile& file, std::optional<double> budget, Json& warnings) {
  using Kind = placement::NamedPlace::Kind;
  const placement::PlacementCounts& p = file.placement;
  const auto add = [&](const char* id, std::size_t count, const char* what, std::initializer_list<Kind> kinds,
                       bool by_hand) {
    if (count > 0)
      warnings.push_back({{"id", id},
                          {"sector", nameOf(file.id)},
                          {"count", count},
                          {"message", fmt::format("sector {}: {} {}: {}", nameOf(file.id), count, what,
                                                  placesOf(p, kinds, by_hand, count))}});
  };
  add("by-hand-dropped", p.by_hand_dropped,
      "probes by hand are left out, inside of geometry without a free place nearby, or past the 255th",
      {Kind::inside, Kind::too_close, Kind::thinned}, true);
  add("by-hand-moved", p.by_hand_moved, "probes by hand were moved out of geometry", {Kind::moved}, true);
  add("probes-dropped", p.inside + p.too_close,
      "places for probes were inside of geometry or too close to it, and none was free nearby",
      {Kind::inside, Kind::too_close}, false);
  add("probes-thinned", p.thinned, "probes past the 255th were left out, those of least loss", {Kind::thinned}, false);
  const auto past = [&](double error, const std::string& what) {
    if (budget && error > *budget)
      warnings.push_back({{"id", "hard-sector"},
                          {"sector", nameOf(file.id)},
                          {"message", fmt::format("sector {}: an error of {:.3g} %, past the budget of {:.3g} %: {}",
                                                  nameOf(file.id), 100.0 * error, 100.0 * *budget, what)}});
  };
  const sectors::SectorError& e = file.error;
  past(totalOf(e), fmt::format("sampling {:.3g} % at probe {}, the sun in {} modes {:.3g} %, encoding {:.3g} %",
                               100.0 * e.sampling, e.sampling_probe, file.probes.modes(), 100.0 * e.modes.worst_row,
                               100.0 * std::max(e.encoding.sky, e.encoding.sun)));
  if (file.local)
    past(totalOf(*file.local), fmt::format("sampling {:.3g} % of the local transfer to probe {}, encoding {:.3g} %",
                                           100.0 * file.local->sampling.error, file.local->sampling.probe,
                                           100.0 * file.local->encoding.radiance));
  add("points-uncovered", p.uncovered, "walkable points see no probe within coverage_m", {Kind::uncovered}, false);
}

/// The entries of all sectors; nothing when one that was not brought up to date now is out of date.
std::optional<std::vector<sectors::SectorEntry>> completed(const LevelInput& level, const LevelOptions& options,
                                                           std::vector<sectors::SectorEntry> entries, Json& warnings) {
  constexpr std::size_t kNamed = 8;
  std::string stale;
  std::size_t count = 0;
  for (const SectorId sector : level.bake.sectors()) {
    const auto is = [&](const sectors::SectorEntry& e) { return e.id == sector; };
    if (std::any_of(entries.begin(), entries.end(), is)) continue;
    endIfInterrupted();
    const SectorState state = level.bake.state(options.folder, sector);
    if (state.stale.empty())
      entries.push_back(build::entryOf(*state.file, state.bytes));
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

/// What every sector must be baked from, as shards must agree on.
base::Hash128 hashOfAll(const LevelInput& level, const LevelOptions& options) {
  std::vector<sectors::SectorEntry> entries;
  for (const SectorId sector : level.bake.sectors()) {
    endIfInterrupted();
    entries.push_back({sector, 0, 0, {}, level.bake.state(options.folder, sector).from.all});
  }
  return hashOf(entries);
}

}  // namespace

void endIfInterrupted() {
  if (interrupted()) throw base::Error(base::ExitStatus::interrupted, "interrupted; what was finished is kept");
}

void addLevelWarnings(const LevelInput& level, Json& warnings) {
  for (const std::string& warning : level.warnings) warnings.push_back({{"id", "geometry"}, {"message", warning}});
  if (level.bake.sectors().empty())
    warnings.push_back({{"id", "no-sectors"},
                        {"message",
                         "the level has no sector: no static surface faces up, nothing is vegetation, and no probe is "
                         "added by hand"}});
}

LevelInput readLevel(const std::filesystem::path& path, const model::Sky& sky, std::optional<double> max_error) {
  const level::LevelFile file = level::readLevelFile(path);
  const build::BakeSection section = build::readBakeSection(path);
  geometry::Surfaces surfaces = loader::readSurfaces(file);
  std::vector<std::filesystem::path> files = surfaces.file;
  std::vector<std::string> warnings = surfaces.warning;
  return {build::LevelBake(std::move(surfaces), section, sky, max_error, endIfInterrupted), std::move(files),
          std::move(warnings)};
}

void bakeSectors(const LevelInput& level, const LevelOptions& options, ProgressReport::Style style, Json& report,
                 Json& timing) {
  const auto wanted = wantedOf(level.bake.sectors(), options);
  Json& warnings = report["warnings"];
  addLevelWarnings(level, warnings);
  base::makeFolder(options.folder / "sectors");
  std::vector<sectors::SectorEntry> entries;
  Json sectors = Json::array();
  {
    SectorBaker baker(level, options, style, wanted.size());
    for (const SectorId sector : wanted) {
      const SectorState state = baker.bring(sector);
      entries.push_back(build::entryOf(*state.file, state.bytes));
      sectors.push_back(reportJson(*state.file, entries.back()));
      addWarnings(*state.file, level.bake.budget(), warnings);
    }
    timing.update(baker.timing());
  }
  report["sectors"] = std::move(sectors);
  sectors::LevelIndex index = level.bake.index();
  if (options.shard) {
    removeParts(options.folder, options.shard->count);
    index.sector = std::move(entries);
    index.all_sectors = hashOfAll(level, options);
    base::writeFile(partPath(options.folder, *options.shard), sectors::encodeLevel(index));
    return;
  }
  auto all = completed(level, options, std::move(entries), warnings);
  if (!all) return;
  index.sector = std::move(*all);
  index.all_sectors = hashOf(index.sector);
  writeIndex(options.folder, index);
  removeOtherSectors(options.folder, index);
  removeParts(options.folder, std::nullopt);
}

}  // namespace welkin::command
