// SPDX-License-Identifier: Apache-2.0
#include "probes/build/sector_report.h"

#include "format/container.h"
#include "probes/geometry/sector_name.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;

/// Null without local transfer.
Json localErrorJson(const std::optional<sectors::BakedLocal>& l) {
  if (!l) return nullptr;
  return {{"total", sectors::totalOf(*l)},
          {"sampling", l->sampling.error},
          {"sampling_probe", l->sampling.probe},
          {"rays", l->sampling.rays},
          {"encoding", {{"position_m", l->encoding.position_m}, {"radiance", l->encoding.radiance}}},
          {"kept", l->thinning.kept},
          {"dropped", l->thinning.dropped},
          {"lost", l->thinning.lost},
          {"lost_of_worst_probe", l->thinning.worst_probe}};
}

}  // namespace

Json errorJson(const sectors::SectorFile& s) {
  const sectors::SectorError& e = s.error;
  return {{"total", sectors::totalOf(e)},
          {"sampling", e.sampling},
          {"sampling_probe", e.sampling_probe},
          {"encoding",
           {{"position_m", e.encoding.position_m},
            {"visibility", e.encoding.visibility},
            {"sky", e.encoding.sky},
            {"sun", e.encoding.sun},
            {"emitted", e.encoding.emitted}}},
          {"modes", {{"rms", e.modes.rms}, {"worst_row", e.modes.worst_row}, {"worst", e.modes.worst}}},
          {"local", localErrorJson(s.local)}};
}

Json placementJson(const sectors::SectorFile& s) {
  const placement::PlacementCounts& c = s.placement;
  Json named = Json::array();
  for (const placement::NamedPlace& n : c.named) {
    const f64::Number3 p = placeInWorld(s.id, n);
    named.push_back({{"kind", format::EnumNamePlaceKind(static_cast<format::PlaceKind>(n.kind))},
                     {"position", {p.x, p.y, p.z}},
                     {"by_hand", n.by_hand}});
    if (n.kind == placement::NamedPlace::Kind::moved) named.back()["moved_m"] = n.moved_m;
  }
  return {{"columns", c.columns},
          {"ground", c.ground},
          {"walkable", c.walkable},
          {"moved", c.moved},
          {"inside", c.inside},
          {"too_close", c.too_close},
          {"thinned", c.thinned},
          {"uncovered", c.uncovered},
          {"cells_without", c.cells_without},
          {"by_hand_moved", c.by_hand_moved},
          {"by_hand_dropped", c.by_hand_dropped},
          {"named", named}};
}

Json fromJson(const sectors::BakedFrom& from) {
  return {{"all", textOf(from.all)},
          {"surfaces", textOf(from.surfaces)},
          {"settings", textOf(from.settings)},
          {"light_paths", textOf(from.light_paths)}};
}

Json reportJson(const sectors::SectorFile& s, const sectors::SectorEntry& entry) {
  return {{"sector", nameOf(s.id)},
          {"file", "sectors/" + geometry::fileNameOf(s.id)},
          {"bytes", entry.bytes},
          {"xxh3_128", textOf(entry.checksum)},
          {"baked_from", fromJson(s.baked_from)},
          {"probes", entry.probes},
          {"probe_bytes", s.probes.bytesAProbe()},
          {"local_bytes", s.local ? s.local->encoded.bytes() : std::size_t{0}},
          {"cut_cells", s.cuts.cell.size()},
          {"cut_bytes", s.cuts.bytes()},
          {"rays", s.rays},
          {"unlit", s.unlit},
          {"error", errorJson(s)},
          {"placement", placementJson(s)}};
}

}  // namespace welkin::build
