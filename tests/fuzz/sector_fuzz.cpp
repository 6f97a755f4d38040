// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a sector's file or of a level's index. The reader stays inside them. An accepted file
// decodes to finite numbers and is written back with the same content.
#include <algorithm>
#include <cstring>
#include <vector>

#include "format/cut_lookup.h"
#include "fuzz.h"
#include "probes/sectors/level_index.h"
#include "probes/sectors/sector_file.h"

namespace welkin::fuzz {
namespace {

void checkLocal(const sectors::BakedLocal& baked, std::size_t count) {
  const transfer::SectorLocal local = transfer::decodedLocal(baked.encoded);
  require(local.probe.size() == count, "every probe has its local transfer");
  require(count == 0 || baked.sampling.probe < count, "the worst probe is there");
  for (const auto& light : local.light) require(isFinite(light), "a virtual light is somewhere");
  for (const auto& probe : local.probe)
    for (const transfer::LocalTransfer& transfer : probe) {
      require(transfer.light < local.light.size(), "a transfer names a light that is there");
      require(transfer.influence() >= 0.0, "an influence is not below 0");
      for (const auto& coefficient : transfer.radiance) require(isFinite(coefficient), "local transfer is finite");
    }
}

/// Points of every cut cell, and of cells beside them, find a leaf with a probe that is there.
void checkCuts(const sectors::SectorFile& sector, std::size_t count) {
  const format::GridView view{sector.grid, sector.low_y, sector.cell_height_m, sector.cuts.view()};
  for (const std::uint16_t cell : sector.cuts.cell)
    for (const float at : {-4.0F, 0.0F, 1.5F, 31.0F, 64.0F}) {
      const format::CutWay way = format::cutWay(view.cuts, cell, 0, {at, 0.5F * at, 64.0F - at}, {0.6F, 0.0F, -0.8F});
      require(way.leaf.probe == geometry::kNoProbe || way.leaf.probe < count, "a leaf names a probe that is there");
      require(way.way_m >= 0.0F, "a plane is ahead");
    }
  const auto gridOf = [&](int x, int z) { return x == 0 && z == 0 ? &view : nullptr; };
  for (const double at : {0.5, 3.9, 31.0, 63.9}) {
    const format::InWorld place = format::pushedPlace({at, sector.low_y + at, 64.0 - at}, {0.0, 1.0, 0.0}, 1.0, gridOf);
    const format::EightProbes found = format::probesAbout(place, gridOf);
    for (std::size_t i = 0; i < found.count; ++i)
      require(found.probe[i].probe < count && found.probe[i].weight > 0.0, "a point's probe is there");
  }
}

void checkSector(const sectors::SectorFile& sector) {
  const transfer::SectorProbes decoded = transfer::decodedProbes(sector.probes, sector.id);
  const std::size_t count = sector.probes.probes();
  require(count <= geometry::kMostProbes && decoded.position.size() == count && decoded.transfer.size() == count &&
              decoded.sun.size() == count,
          "every probe is there");
  for (const std::uint8_t cell : sector.grid)
    require(cell == geometry::kNoProbe || cell < count, "a cell names a probe that is there");
  for (const auto& position : decoded.position) require(isFinite(position), "a position is finite");
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      const double visibility = decoded.transfer[i].visibility[b];
      require(visibility >= 0.0 && visibility <= 1.0, "a visibility is 0 to 1");
      const auto& sky = decoded.transfer[i].sky[b];
      for (const auto& coefficient : sky) require(isFinite(coefficient), "the sky is finite");
      for (const auto& never_below_0 : {sky[0], sky[1], decoded.transfer[i].emitted[b]})
        require(isFinite(never_below_0) && std::min({never_below_0.x, never_below_0.y, never_below_0.z}) >= 0.0,
                "light of the whole sky and of surfaces is not below 0");
      for (const double number : decoded.sun[i][b]) require(std::isfinite(number), "the sun is finite");
    }
  for (const auto& mode : decoded.modes.value) require(isFinite(mode), "a mode is finite");
  if (sector.local) checkLocal(*sector.local, count);
  checkCuts(sector, count);
  const auto written = sectors::encodeSector(sector);
  require(sectors::encodeSector(sectors::decodeSector(written, "what was written")) == written,
          "it is written as read");
}

}  // namespace
}  // namespace welkin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  std::vector<std::byte> copy(size);  // of the exact size, so that a read past the end is caught
  if (size > 0) std::memcpy(copy.data(), bytes, size);
  fuzz::accepts([&] { fuzz::checkSector(sectors::decodeSector(copy, "the input")); });
  fuzz::accepts([&] {
    const auto written = sectors::encodeLevel(sectors::decodeLevel(copy, "the input"));
    fuzz::require(sectors::encodeLevel(sectors::decodeLevel(written, "what was written")) == written,
                  "an index is written as read");
  });
  return 0;
}
