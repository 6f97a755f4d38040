// SPDX-License-Identifier: Apache-2.0
// A sector's file gives everything back, and no error in it passes.
#include "probes/sectors/sector_file.h"

#include <catch2/catch.hpp>

#include "probes/sectors/level_index.h"
#include "sky/base/error.h"

namespace welkin::tests {
namespace {

/// Two probes, two modes over three knots of the sun and one of the moon, and emitted light.
sectors::SectorFile someSector() {
  sectors::SectorFile s;
  s.id = {-3, 7};
  s.low_y = -12.5;
  s.cell_height_m = 5.0;
  s.grid.fill(geometry::kNoProbe);
  s.grid[17] = 1;
  s.top[255] = 1;
  s.room = {{{{-190, -1, 450}, {-180, 3.5, 460}}, geometry::kNoProbe}, {{{-160, 0, 450}, {-150, 4, 470}}, 1}};
  s.in_room = {0, 2};
  s.door = {{{{-155, 0, 468}, {-152, 2, 471.5}}, 1}};
  s.unlit = 1;
  s.cuts.cell = {17, 4095};
  s.cuts.tree = {0, 2};
  s.cuts.node = {0, 0, 0x8000, 0x81ff, 0x8101};
  s.cuts.plane = {{32767, 0, 2.5F}};
  s.cuts.mask = {format::kAllOpen, format::kOwnOpen};
  s.sun = transfer::SunTransfer::directional;
  transfer::EncodedProbes& p = s.probes;
  p.low_y = -1.0F;
  p.high_y = 2.0F;
  p.position = {0, 1, 2, 65535, 4, 5};
  p.visibility = {0, 65535, 7, 8, 9, 10};
  p.sky_scale = {0x3f80, 0x4000};
  for (int i = 0; i < 48; ++i) p.sky.push_back(static_cast<std::uint8_t>(i * 5));
  for (int i = 0; i < 48; ++i) p.sky_side.push_back(static_cast<std::int8_t>(i * 5 - 127));
  p.sun_scale = {0x3f00, 0};
  for (int i = 0; i < 16; ++i) p.sun.push_back(static_cast<std::int8_t>(i * 16 - 127));
  p.emitted_scale = {0, 0x3f80};
  p.emitted.assign(24, 200);
  p.sun_time_h = {6.0F, 12.0F, 17.5F};
  p.moon_time_h = {0.0F};
  p.coefficient_scale = {1.0F, 0.5F};
  p.mode_scale = {1.0F, 0.25F};
  for (int i = 0; i < 24; ++i) p.mode.push_back(static_cast<std::int8_t>(i - 12));
  s.settings = R"({"transfer": {}})";
  s.baked_from = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
  using Kind = placement::NamedPlace::Kind;
  s.placement = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, {}};
  s.placement.named = {{{-190.25, 1, 450}, 0.0, Kind::thinned, true}, {{-180, 2, 460.1}, 0.25, Kind::moved, true}};
  s.rays = 12345678901;
  s.error = {0.1, 1, {0.01, 0.02, 0.03, 0.04, 0.05}, {0.06, 0.07, 0.08}};
  return s;
}

/// The same with local transfer of two lights. The first probe has one light, the second both.
sectors::SectorFile someLitSector() {
  sectors::SectorFile s = someSector();
  sectors::BakedLocal& local = s.local.emplace();
  local.encoded.position = {-180.0F, 1.0F, 460.0F, -130.0F, 2.0F, 450.0F};
  local.encoded.count = {1, 2};
  local.encoded.light = {1, 0, 1};
  local.encoded.scale = {0x3f80, 0x3f00, 0};
  for (int i = 0; i < 36; ++i)
    local.encoded.radiance.push_back(static_cast<std::int8_t>(i % 12 < 3 ? i * 3 : i * 6 - 100));
  local.sampling = {0.11, 1, 1U << 20};
  local.encoding = {0.12, 0.13};
  local.thinning = {3, 14, 0.15, 0.16};
  return s;
}

void checkSectorRefused(const sectors::SectorFile& sector, const std::string& says) {
  INFO(says);
  try {
    sectors::decodeSector(sectors::encodeSector(sector), "the sector");
    FAIL("it was read");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    CHECK_THAT(e.what(), Catch::Contains("the sector") && Catch::Contains(says));
  }
}

}  // namespace

TEST_CASE("SectorFile, GivesBackWhatItWasGiven") {
  const sectors::SectorFile s = someSector();
  const std::vector<std::byte> bytes = sectors::encodeSector(s);
  const sectors::SectorFile r = sectors::decodeSector(bytes, "the sector");
  CHECK(sectors::encodeSector(r) == bytes);
  CHECK(r.id == s.id);
  CHECK(r.low_y == s.low_y);
  CHECK(r.cell_height_m == s.cell_height_m);
  CHECK(r.grid == s.grid);
  CHECK(r.sun == s.sun);
  CHECK(r.probes.position == s.probes.position);
  CHECK(r.probes.sky == s.probes.sky);
  CHECK(r.probes.sky_side == s.probes.sky_side);
  CHECK(r.probes.sun == s.probes.sun);
  CHECK(r.probes.mode == s.probes.mode);
  CHECK(r.probes.bytes().total() == s.probes.bytes().total());
  CHECK(r.settings == s.settings);
  CHECK(r.baked_from == s.baked_from);
  CHECK(r.placement.cells_without == 9);
  CHECK(r.placement.by_hand_moved == 10);
  CHECK(r.placement.by_hand_dropped == 11);
  CHECK(r.placement.named == s.placement.named);
  CHECK(r.rays == s.rays);
  CHECK(r.top == s.top);
  CHECK(r.in_room == s.in_room);
  REQUIRE(r.room.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK((r.room[i].box == s.room[i].box && r.room[i].probe == s.room[i].probe));
  CHECK(r.unlit == 1);
  REQUIRE(r.door.size() == 1);
  CHECK((r.door[0].box == s.door[0].box && r.door[0].room == 1));
  CHECK(r.cuts.cell == s.cuts.cell);
  CHECK(r.cuts.tree == s.cuts.tree);
  CHECK(r.cuts.node == s.cuts.node);
  CHECK(r.cuts.mask == s.cuts.mask);
  REQUIRE(r.cuts.plane.size() == 1);
  CHECK(r.cuts.plane[0].u() == 32767);
  CHECK(r.cuts.plane[0].offset() == 2.5F);
  CHECK(r.error.sampling_probe == 1);
  CHECK(r.error.encoding.emitted == 0.05);
  CHECK(r.error.modes.worst == 0.08);
  sectors::SectorFile empty;
  empty.grid.fill(geometry::kNoProbe);
  empty.top.fill(geometry::kNoProbe);
  CHECK(sectors::decodeSector(sectors::encodeSector(empty), "the sector").probes.probes() == 0);
}

TEST_CASE("SectorFile, GivesBackLocalTransfer") {
  const sectors::SectorFile s = someLitSector();
  const std::vector<std::byte> bytes = sectors::encodeSector(s);
  const sectors::SectorFile r = sectors::decodeSector(bytes, "the sector");
  CHECK(sectors::encodeSector(r) == bytes);
  REQUIRE(r.local);
  CHECK(r.local->encoded.position == s.local->encoded.position);
  CHECK(r.local->encoded.count == s.local->encoded.count);
  CHECK(r.local->encoded.light == s.local->encoded.light);
  CHECK(r.local->encoded.scale == s.local->encoded.scale);
  CHECK(r.local->encoded.radiance == s.local->encoded.radiance);
  CHECK(r.local->sampling.error == 0.11);
  CHECK(r.local->sampling.probe == 1);
  CHECK(r.local->sampling.rays == 1U << 20);
  CHECK(r.local->encoding.position_m == 0.12);
  CHECK(r.local->encoding.radiance == 0.13);
  CHECK(r.local->thinning.kept == 3);
  CHECK(r.local->thinning.dropped == 14);
  CHECK(r.local->thinning.lost == 0.15);
  CHECK(r.local->thinning.worst_probe == 0.16);
  CHECK(transfer::decodedLocal(r.local->encoded).probe[1][1].light == 1);
  CHECK_FALSE(sectors::decodeSector(sectors::encodeSector(someSector()), "the sector").local);
  const std::size_t without = sectors::encodeSector(someSector()).size();
  CHECK(bytes.size() > without + s.local->encoded.bytes());
}

TEST_CASE("SectorFile, LocalTransferThatDoesNotFitIsRefused") {
  const auto refused = [](const std::string& says, auto change) {
    sectors::SectorFile s = someLitSector();
    change(*s.local);
    checkSectorRefused(s, says);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  refused("position for every light", [](auto& l) { l.encoded.position.pop_back(); });
  refused("position for every light", [=](auto& l) { l.encoded.position[4] = nan; });
  refused("position for every light", [](auto& l) { l.encoded.position[0] = -1.1e7F; });
  refused("position for every light", [](auto& l) { l.encoded.position.resize(3 * 65537); });
  refused("count for every probe", [](auto& l) { l.encoded.count = {3}; });
  refused("count for every probe", [](auto& l) { l.encoded.count = {1, 2, 0}; });
  refused("count for every probe", [](auto& l) {
    l.encoded.count[0] = 129;
    l.encoded.position.resize(3 * 200);
  });
  refused("every number", [](auto& l) { l.encoded.count[0] = 2; });
  refused("every number", [](auto& l) { l.encoded.light.push_back(1); });
  refused("every number", [](auto& l) { l.encoded.scale.pop_back(); });
  refused("every number", [](auto& l) { l.encoded.radiance.pop_back(); });
  refused("ascending lights", [](auto& l) { l.encoded.light[0] = 2; });
  refused("ascending lights", [](auto& l) { l.encoded.light = {1, 1, 0}; });
  refused("ascending lights", [](auto& l) { l.encoded.light = {1, 1, 1}; });
  refused("a scale", [](auto& l) { l.encoded.scale[1] = 0x7f80; });  // infinite
  refused("a scale", [](auto& l) { l.encoded.scale[2] = 0xbf80; });  // -1
  refused("influence below 0", [](auto& l) { l.encoded.radiance[14] = -1; });
  refused("the errors", [](auto& l) { l.sampling.error = -0.1; });
  refused("the errors", [](auto& l) { l.sampling.probe = 2; });
  refused("the errors", [](auto& l) { l.thinning.lost = 1.1; });
  refused("the errors", [](auto& l) { l.encoding.radiance = std::numeric_limits<double>::quiet_NaN(); });
}

TEST_CASE("SectorFile, EveryLengthDomainAndIndexIsChecked") {
  const auto refused = [](const std::string& says, auto change) {
    sectors::SectorFile s = someSector();
    change(s);
    checkSectorRefused(s, says);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  refused("the grid names a probe", [](auto& s) { s.grid[4095] = 2; });
  refused("the doors must be at most 254", [](auto& s) { s.door.resize(255, s.door[0]); });
  refused("the doors must be of a room", [](auto& s) { s.door[0].room = 2; });
  refused("the doors must be of a room", [](auto& s) {
    s.room.clear();
    s.in_room.clear();
  });
  refused("the doors must cross one face", [](auto& s) { s.door[0].room = 0; });
  refused("the doors must cross one face", [](auto& s) { s.door[0].box.high.z = 470; });
  refused("the doors must cross one face", [](auto& s) { s.door[0].box.low.z = 449; });
  refused("the doors must cross one face", [](auto& s) { std::swap(s.door[0].box.low.x, s.door[0].box.high.x); });
  refused("the doors must be within", [=](auto& s) { s.door[0].box.low.y = double{nan}; });
  refused("the doors must be within", [](auto& s) { s.door[0].box.high.z = 1.1e7; });
  refused("the grid has a height", [=](auto& s) { s.cell_height_m = 0.0; });
  refused("the grid has a height", [=](auto& s) { s.low_y = double{nan}; });
  refused("the sector", [](auto& s) { s.id.x = 15626; });
  refused("the view from above", [](auto& s) { s.top[3] = 2; });
  refused("the view from above", [](auto& s) { s.top[3] = geometry::kNoProbe; });
  refused("the unlit", [](auto& s) { s.unlit = 3; });
  refused("must have moved where", [](auto& s) { s.placement.named[0].moved_m = 1.0; });
  refused("must have moved where", [](auto& s) { s.placement.named[1].moved_m = -1.0; });
  refused("must be of a kind",
          [](auto& s) { s.placement.named[0].kind = static_cast<placement::NamedPlace::Kind>(5); });
  refused("the named places must be within", [=](auto& s) { s.placement.named[0].position.z = double{nan}; });
  refused("at most 32", [](auto& s) { s.placement.named.resize(33, s.placement.named[0]); });
  refused("the rooms must be there", [](auto& s) { s.room.clear(); });
  refused("the rooms must say", [](auto& s) { s.in_room.pop_back(); });
  refused("the rooms must say", [](auto& s) { s.in_room[0] = 3; });
  refused("a probe of their own", [](auto& s) { s.in_room[1] = 1; });
  refused("a probe of their own", [](auto& s) { s.room[1].probe = 2; });
  refused("must be boxes", [](auto& s) { std::swap(s.room[0].box.low, s.room[0].box.high); });
  refused("must be boxes", [=](auto& s) { s.room[1].box.high.y = double{nan}; });
  refused("at most 254", [](auto& s) { s.room.resize(255, s.room[0]); });
  refused("a position", [](auto& s) { s.probes.position.pop_back(); });
  refused("a visibility", [](auto& s) { s.probes.visibility.push_back(0); });
  refused("coefficient of the sky", [](auto& s) { s.probes.sky.pop_back(); });
  refused("coefficient of the sky", [](auto& s) { s.probes.sky_side.push_back(1); });
  refused("number of the sun", [](auto& s) { s.probes.sun.pop_back(); });
  refused("number of the sun", [](auto& s) { s.probes.sun_scale.clear(); });
  refused("emitted light", [](auto& s) { s.probes.emitted_scale.pop_back(); });
  refused("emitted light", [](auto& s) { s.probes.emitted.pop_back(); });
  refused("number for every mode", [](auto& s) { s.probes.mode.pop_back(); });
  refused("two scales", [](auto& s) { s.probes.coefficient_scale.pop_back(); });
  refused("ascending knots", [](auto& s) { s.probes.sun_time_h[1] = 6.0F; });
  refused("ascending knots", [](auto& s) { s.probes.moon_time_h[0] = 24.0F; });
  refused("ascending knots", [=](auto& s) { s.probes.sun_time_h[2] = nan; });
  refused("not directional", [](auto& s) { s.sun = transfer::SunTransfer::sh; });
  refused("a scale", [](auto& s) { s.probes.sky_scale[0] = 0x7f80; });      // infinite
  refused("a scale", [](auto& s) { s.probes.sky_scale[0] = 0x7fc0; });      // NaN
  refused("a scale", [](auto& s) { s.probes.sun_scale[0] = 0xbf80; });      // -1
  refused("a scale", [](auto& s) { s.probes.emitted_scale[0] = 0x8000; });  // -0
  refused("a scale", [](auto& s) { s.probes.mode_scale[0] = -1.0F; });
  refused("a height", [](auto& s) { s.probes.high_y = -2.0F; });
  refused("the errors", [](auto& s) { s.error.sampling_probe = 2; });
  refused("the errors", [](auto& s) { s.error.encoding.sky = -1.0; });
}

TEST_CASE("SectorFile, CutsThatDoNotFitAreRefused") {
  const auto refused = [](const std::string& says, auto change) {
    sectors::SectorFile s = someSector();
    change(s.cuts);
    checkSectorRefused(s, says);
  };
  refused("ascending cells", [](auto& c) { c.cell[1] = 4096; });
  refused("ascending cells", [](auto& c) { c.cell[1] = 17; });
  refused("tree for every cell", [](auto& c) { c.tree.pop_back(); });
  refused("tree for every cell", [](auto& c) { c.tree.clear(); });
  refused("whole trees", [](auto& c) { c.tree[0] = 5; });
  refused("whole trees", [](auto& c) { c.node.pop_back(); });   // the last leaf is missing
  refused("whole trees", [](auto& c) { c.node[1] = 1; });       // a plane,
  refused("whole trees", [](auto& c) { c.node[4] = 0x8201; });  // a mask
  refused("whole trees", [](auto& c) { c.node[2] = 0x8002; });  // and a probe that are not there
  refused("whole trees", [](auto& c) { c.plane.clear(); });
  refused("whole trees", [](auto& c) { c.mask.pop_back(); });
  refused("whole trees", [](auto& c) {
    c.node.assign(64, 0);  // 64 planes and 65 leaves
    c.node.resize(129, 0x8000);
  });
  refused("at most 65535 nodes", [](auto& c) { c.node.resize(65536, 0x8000); });
  refused("32768 planes", [](auto& c) { c.plane.resize(32769, c.plane[0]); });
  refused("at most 128 masks", [](auto& c) { c.mask.resize(129, format::kAllOpen); });
  refused("open to its own", [](auto& c) { c.mask[0] = format::openBit(0, 1, 0); });
  refused("open to its own", [](auto& c) { c.mask[0] |= 1U << 27; });
  const float nan = std::numeric_limits<float>::quiet_NaN();
  refused("a plane out of", [=](auto& c) { c.plane[0] = {0, 0, nan}; });
  refused("a plane out of", [](auto& c) { c.plane[0] = {-32768, 0, 0.0F}; });
  refused("a plane out of", [](auto& c) { c.plane[0] = {0, 0, 1.1e7F}; });
  sectors::SectorFile largest = someSector();
  largest.cuts.node.assign(63, 0);
  largest.cuts.node.resize(127, 0x8000);
  largest.cuts.tree = {0, 126};
  CHECK(sectors::decodeSector(sectors::encodeSector(largest), "it").cuts.node.size() == 127);
}

TEST_CASE("SectorFile, NoByteMayChangeAndNoneMayBeMissing") {
  const std::vector<std::byte> bytes = sectors::encodeSector(someLitSector());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> other = bytes;
    other[i] ^= std::byte{1};
    CHECK_THROWS_AS(sectors::decodeSector(other, "it"), base::Error);
    CHECK_THROWS_AS(sectors::decodeSector(std::span(bytes).first(i), "it"), base::Error);
  }
}

TEST_CASE("LevelIndex, GivesBackWhatItWasGivenAndChecks") {
  sectors::LevelIndex index;
  index.sector = {{{-1, 2}, 3, 4, {5, 6}, {7, 8}}, {{-1, 3}, 70, 15000, {9, 10}, {11, 12}}};
  index.all_sectors = hashOf(index.sector);
  index.sky_checksum = base::Hash128{13, 14};
  index.sun = transfer::SunTransfer::directional;
  index.sun_path = model::LightPath{0.1, 0.2, 12.5, 0.3, {}, {}, {}};
  index.moon_path = model::LightPath{0.0, 0.0, 12.0, 0.0, {1.0, 2.0}, {0.5, 0.6}, {0.7, -0.8}};
  index.scale = {2.0, 3.0};
  index.settings = "{}";
  const auto bytes = sectors::encodeLevel(index);
  const sectors::LevelIndex r = sectors::decodeLevel(bytes, "it");
  CHECK(sectors::encodeLevel(r) == bytes);
  CHECK(r.sector[1].id == geometry::SectorId{-1, 3});
  CHECK(r.sector[1].checksum == base::Hash128{9, 10});
  CHECK(r.scale.sky == 2.0);
  CHECK(r.moon_path->key_elevation_rad[1] == -0.8);
  const auto refused = [&](const std::string& says, auto change) {
    sectors::LevelIndex other = index;
    change(other);
    CHECK_THROWS_WITH(sectors::decodeLevel(sectors::encodeLevel(other), "it"), Catch::Contains(says));
  };
  refused("must ascend", [](auto& i) { std::swap(i.sector[0], i.sector[1]); });
  refused("must ascend", [](auto& i) { i.sector[0].id = i.sector[1].id; });
  refused("out of its domain", [](auto& i) { i.sector[0].probes = 256; });
  refused("must have a path", [](auto& i) { i.sun_path.reset(); });
  refused("path times", [](auto& i) { i.moon_path->key_time_h = {2.0, 1.0}; });
  refused("scale", [](auto& i) { i.scale.sky = -1.0; });
}

}  // namespace welkin::tests
