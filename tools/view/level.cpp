// SPDX-License-Identifier: Apache-2.0
#include "view/level.h"

#include <fmt/format.h>

#include "baked/level_source.h"
#include "probes/build/level_bake.h"
#include "probes/build/level_files.h"
#include "probes/build/sector_warnings.h"
#include "probes/contact/contact_file.h"
#include "probes/geometry/sector_name.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::view {
namespace {

namespace fs = std::filesystem;
using sectors::SectorFile;

f64::Number3 middleOf(const level::Bounds& bounds) {
  return bounds.empty() ? f64::Number3(0.0) : (bounds.low + bounds.high) * 0.5;
}

level::Scene drawnScene(const fs::path& level) {
  level::Scene scene = loader::readScene(level::levelFileOf(base::readToml(level.string())));
  loader::useMeanColours(scene);  // the passes draw no textures
  return scene;
}

/// The first place that a sector's warnings are about, or the middle of the sector.
f64::Number3 placeToLookAt(const SectorFile& sector) {
  if (!sector.placement.named.empty()) return placement::placeInWorld(sector.id, sector.placement.named.front());
  return geometry::cornerOf(sector.id) +
         f64::Number3(0.5 * geometry::kSector_m, sector.low_y, 0.5 * geometry::kSector_m);
}

/// Adds a sector's bytes and complaints.
void addTo(std::vector<SectorCost>& costs, std::vector<Warning>& warnings, const sectors::SectorEntry& entry,
           const SectorFile& file, std::optional<double> budget) {
  costs.push_back({entry.id, entry.probes, static_cast<std::size_t>(entry.bytes)});
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  build::addWarnings(file, budget, list);
  for (const auto& one : list) warnings.push_back({one["id"], one["message"], placeToLookAt(file)});
  if (file.unlit == 0) return;
  const std::string probes = file.unlit == 1 ? "1 probe gets" : fmt::format("{} probes get", file.unlit);
  warnings.push_back({"unlit",
                      fmt::format("sector {}: {} no light of sky, sun, moon or emission", nameOf(entry.id), probes),
                      placeToLookAt(file)});
}

/// Takes the folder's contact factors into the scene. Those of another bake are left out, with a warning.
void takeContact(level::Scene& scene, const fs::path& folder, std::span<const std::byte> index,
                 std::vector<Warning>& warnings) {
  scene.contact.clear();
  scene.first_contact.clear();
  try {
    contact::addContact(scene, folder, base::hashOf(index));
  } catch (const base::Error& e) {
    warnings.push_back({"contact", fmt::format("contact factors are left out: {}", e.what()), {}});
  }
}

}  // namespace

LevelFiles levelFiles(const fs::path& folder, const fs::path& level) {
  if (!build::isLevelFolder(folder))
    throw base::Error(base::ExitStatus::file,
                      fmt::format("{}: not the folder of a baked level: it has no level.welkin; welkin bake LEVEL.toml "
                                  "-o {} makes it",
                                  folder.string(), folder.string()));
  baked::LevelSource source = baked::levelSource(folder, level);
  return {folder, std::move(source.file), std::move(source.warning)};
}

Level::Level(const LevelFiles& files)
    : files_(files),
      subject_(build::readLevel(files.level)),
      scene_(drawnScene(files.level)),
      tracer_(std::make_unique<geometry::Tracer>(subject_.level->surfaces, middleOf(scene_.bounds))) {
  reload();
}

void Level::reload(const std::map<geometry::SectorId, std::vector<std::byte>>& instead) {
  if (instead.empty()) files_ = levelFiles(files_.folder, files_.level);
  const fs::path index_path = build::indexPath(files_.folder);
  sectors::LevelIndex index = build::readIndex(index_path);
  std::vector<SectorFile> files;
  std::vector<SectorCost> costs;
  std::vector<Warning> warnings;
  baked::LevelFolder::Instead bytes_instead;
  if (!files_.warning.empty()) warnings.push_back({"stale", files_.warning, {}});
  for (const std::string& warning : subject_.level->surfaces.warning) warnings.push_back({"geometry", warning, {}});
  const bool has_budget = !subject_.level->section.transfer.rays;
  for (sectors::SectorEntry& entry : index.sector) {
    const fs::path path = files_.folder / "sectors" / geometry::fileNameOf(entry.id);
    const auto other = instead.find(entry.id);
    const std::vector<std::byte> bytes = other == instead.end() ? base::readFile(path) : other->second;
    files.push_back(sectors::decodeSector(bytes, path.string()));
    if (other != instead.end()) {
      entry = build::entryOf(files.back(), bytes);
      bytes_instead.emplace(path, bytes);
    }
    addTo(costs, warnings, entry, files.back(), has_budget ? subject_.sky.bake.max_error : std::nullopt);
  }
  index.all_sectors = sectors::hashOf(index.sector);
  if (!bytes_instead.empty()) bytes_instead.emplace(index_path, sectors::encodeLevel(index));
  const std::vector<std::byte> index_bytes =
      bytes_instead.empty() ? base::readFile(index_path) : bytes_instead.at(index_path);
  baked_ = std::make_unique<baked::LevelFolder>(files_.folder, 0, bytes_instead);
  sectors_ = std::move(files);
  costs_ = std::move(costs);
  warnings_ = std::move(warnings);
  takeContact(scene_, files_.folder, index_bytes, warnings_);
}

const SectorFile* Level::sector(geometry::SectorId id) const {
  const auto found =
      std::lower_bound(sectors_.begin(), sectors_.end(), id,
                       [](const SectorFile& file, geometry::SectorId wanted) { return file.id < wanted; });
  return found == sectors_.end() || found->id != id ? nullptr : &*found;
}

f64::Number3 Level::placeOf(const ProbeName& name) const {
  const SectorFile& file = *sector(name.sector);
  return transfer::decodedProbes(file.probes, file.id).position.at(name.number);
}

}  // namespace welkin::view
