// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a sector's file or of a level's index. The reader stays inside them. An accepted file
// decodes to finite numbers and is written back with the same content.
#include <algorithm>
#include <cstring>
#include <vector>

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
