// SPDX-License-Identifier: Apache-2.0
#include "picture/probe_picture.h"

#include <catch2/catch.hpp>
#include <cstdint>

#include "probes/placement/placement.h"
#include "tests/probes/rooms.h"

namespace welkin::picture {
namespace {

std::uint32_t bigEndianAt(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

}  // namespace

TEST_CASE("ProbePicture, FromAboveAndInSection") {
  geometry::Surfaces s = tests::groundOf({0.5, 0.5, 0.5});
  tests::addBoxOutside(s, {10, 0, 10}, {30, 6, 50}, 0);
  const geometry::Tracer tracer(s);
  std::vector<geometry::PlacedSector> sectors;
  for (const geometry::SectorId id : {geometry::SectorId{-1, 0}, geometry::SectorId{0, 0}}) {
    placement::PlacementReport report;
    sectors.push_back(placement::placeSector(tracer, id, {}, report));
  }
  const std::string above = drawFromAbove(tracer, sectors);
  const std::string section = drawSection(tracer, sectors, 20.3);
  CHECK(above.substr(1, 3) == "PNG");
  CHECK(bigEndianAt(above, 16) == 128 * 10 + 8);
  CHECK(bigEndianAt(above, 20) == 64 * 10 + 8);
  CHECK(section.substr(1, 3) == "PNG");
  CHECK(bigEndianAt(section, 16) == 128 * 10 + 8);
  CHECK(bigEndianAt(section, 20) == 15 * 10 + 8);  // 8 m above the probes on the roof
  CHECK((above == drawFromAbove(tracer, sectors)));
  CHECK((section != drawSection(tracer, sectors, 5.0)));
}

TEST_CASE("ProbePicture, NothingIsASmallPicture") {
  const geometry::Surfaces s;
  const geometry::Tracer tracer(s);
  CHECK(drawFromAbove(tracer, {}).substr(1, 3) == "PNG");
  CHECK(drawSection(tracer, {}, 0.0).substr(1, 3) == "PNG");
}

}  // namespace welkin::picture
