// SPDX-License-Identifier: Apache-2.0
#include "probes/build/sector_warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "probes/build/level_hints.h"
#include "probes/geometry/sector_name.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;
using sectors::SectorFile;

/// The first places of some kinds, or of those the ones by hand, and how many more there are.
std::string placesOf(const SectorFile& file, std::initializer_list<placement::NamedPlace::Kind> kinds, bool by_hand,
                     std::size_t count) {
  const std::size_t most = by_hand ? placement::kMostNamedByHand : placement::kMostNamed;
  std::string text;
  std::size_t named = 0;
  for (const placement::NamedPlace& n : file.placement.named) {
    if ((by_hand && !n.by_hand) || named == most || std::find(kinds.begin(), kinds.end(), n.kind) == kinds.end())
      continue;
    const f64::Number3 p = placeInWorld(file.id, n);
    text += named++ > 0 ? ", " : "";
    text +=
        n.by_hand ? fmt::format("[{}, {}, {}]", p.x, p.y, p.z) : fmt::format("[{:.2f}, {:.2f}, {:.2f}]", p.x, p.y, p.z);
    if (n.moved_m > 0.0) text += fmt::format(" by {:.2f} m", n.moved_m);
  }
  if (named == 0) return fmt::format("{} that are not named", count);
  return count > named ? fmt::format("{} and {} more", text, count - named) : text;
}

}  // namespace

void addWarnings(const LevelBake& level, Json& warnings) {
  for (const std::string& warning : level.surfaces().warning)
    warnings.push_back({{"id", "geometry"}, {"message", warning}});
  if (const auto dome = domeAround(level.surfaces()))
    warnings.push_back(
        {{"id", "sky-dome"},
         {"message", fmt::format("object \"{0}\" encloses the level and hides its sky; if it is a mesh for the sky, "
                                 "ignore_nodes = [\"{0}\"] in its [[geometry]] leaves it out",
                                 *dome)}});
  if (seemsInCentimetres(level.surfaces(), level.sectors().size()))
    warnings.push_back(
        {{"id", "centimetres"},
         {"message", fmt::format("the level has {} sectors of 64 m, and most triangles are longer than 30 "
                                 "m; if it is in centimetres, scale = 0.01 in its [[geometry]] mends it",
                                 level.sectors().size())}});
  if (level.sectors().empty())
    warnings.push_back({{"id", "no-sectors"},
                        {"message",
                         "the level has no sector: no static surface faces up, nothing is vegetation, and no probe is "
                         "added by hand"}});
}

void addProbelessWarning(std::size_t sectors, std::size_t probes, Json& warnings) {
  if (sectors > 0 && probes == 0)
    warnings.push_back(
        {{"id", "no-probes"},
         {"message", fmt::format("none of the {} sectors keeps a probe: every place is inside of geometry "
                                 "or too close to it; faces that are turned inside out look like that",
                                 sectors)}});
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
                                                  placesOf(file, kinds, by_hand, count))}});
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

}  // namespace welkin::build
