// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/look_up.h"

#include <algorithm>

#include "format/doors.h"
#include "probes/placement/settings.h"

namespace welkin::fit {
namespace {

constexpr double kPush_m = 1.0;  ///< as the runtime's default

void add(std::uint32_t probe, double weight, PointWeights& sum) {
  const auto same =
      std::find_if(sum.probe.begin(), sum.probe.end(), [&](const PointWeights::Entry& e) { return e.probe == probe; });
  if (same == sum.probe.end())
    sum.probe.push_back({probe, weight});
  else
    same->weight += weight;
}

}  // namespace

LookUp::LookUp(const geometry::PlacedSector& sector, const placement::SectorCuts& cuts)
    : sector_(sector), grid_{sector.grid, sector.low_y, sector.cell_height_m, cuts.view()} {}

std::size_t LookUp::roomAt(const Number3& position) const {
  for (std::size_t i = 0; i < sector_.room.size(); ++i)
    if (geometry::contains(sector_.room[i].box, position)) return i + 1;
  return 0;
}

PointWeights LookUp::at(const FitPoint& point) const {
  const auto gridOf = [&](int x, int z) { return x == 0 && z == 0 ? &grid_ : nullptr; };
  const format::InWorld place = format::pushedPlace({point.position.x, point.position.y, point.position.z},
                                                    {point.normal.x, point.normal.y, point.normal.z}, kPush_m, gridOf);
  PointWeights result = ofSide(place);
  for (const geometry::Door& door : sector_.door) {
    const auto way = format::doorWayOf(placement::doorBoxOf(door.box, sector_.room[door.room].box));
    const format::BeyondDoor beyond = format::beyondDoor(way, place);
    if (!(beyond.share > 0.0)) continue;
    const PointWeights other = ofSide(beyond.place);
    if (other.probe.empty()) return result;
    if (result.probe.empty()) return other;
    for (PointWeights::Entry& e : result.probe) e.weight *= 1.0 - beyond.share;
    for (const PointWeights::Entry& e : other.probe) add(e.probe, beyond.share * e.weight, result);
    result.share += beyond.share * (other.share - result.share);
    return result;
  }
  return result;
}

PointWeights LookUp::ofSide(const format::InWorld& place) const {
  const auto gridOf = [&](int x, int z) { return x == 0 && z == 0 ? &grid_ : nullptr; };
  const std::size_t room = roomAt({place[0], place[1], place[2]});
  const format::EightProbes found = format::probesAbout(place, gridOf);
  PointWeights result;
  for (std::size_t i = 0; i < found.count; ++i) {
    const format::WeightedProbe& p = found.probe[i];
    if ((sector_.in_room.empty() ? 0U : sector_.in_room[p.probe]) != room) continue;
    result.share += p.weight;
    add(p.probe, p.weight, result);
  }
  if (result.probe.empty() && room > 0 && sector_.room[room - 1].probe != geometry::kNoProbe)
    return {{{sector_.room[room - 1].probe, 1.0}}, 1.0};
  for (PointWeights::Entry& e : result.probe) e.weight /= result.share;
  return result;
}

}  // namespace welkin::fit
