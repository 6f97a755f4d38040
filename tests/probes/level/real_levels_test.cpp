// SPDX-License-Identifier: Apache-2.0
// Levels of games. It runs if WELKIN_DATA names a folder with them under levels/.
#include <cstdlib>

#include "level_text.h"

namespace welkin::tests {
namespace {

/// The surfaces of a file in the folder; nothing, with a warning, if there is no such folder.
std::optional<geometry::Surfaces> read(const std::string& file, double scale = 1.0) {
  const char* folder = std::getenv("WELKIN_DATA");
  if (folder == nullptr) {
    WARN("skipped: WELKIN_DATA names no folder with levels/" << file);
    return std::nullopt;
  }
  level::LevelFile level;
  level.geometry.push_back({std::filesystem::path(folder) / "levels" / file,
                            geometry::fromEuler(Number3(0.0), Number3(0.0), Number3(scale)),
                            geometry::Role::fixed,
                            {}});
  return loader::surfacesOf(loader::readScene(level), 1.0);
}

void checkBounds(const geometry::Surfaces& s, const Number3& low, const Number3& high) {
  level::Bounds bounds;
  for (const geometry::Triangle& t : s.triangle)
    for (const uint32_t v : t.vertex)
      bounds.add({double{s.position[v][0]}, double{s.position[v][1]}, double{s.position[v][2]}});
  constexpr double kHalfOfTheLastDigit = 0.005;
  checkNear(bounds.low, low, kHalfOfTheLastDigit);
  checkNear(bounds.high, high, kHalfOfTheLastDigit);
}

/// Share of rays straight down, on a lattice over everything, that first meet a back.
double shareOfBacks(const geometry::Surfaces& s, double half, double step) {
  const geometry::Tracer tracer(s);
  int backs = 0;
  int all = 0;
  for (double x = -half; x < half; x += step)
    for (double z = -half; z < half; z += step)
      if (const auto hit = tracer.closest({x + 0.037, 1000.0, z + 0.053}, {0.0, -1.0, 0.0}, 1e5)) {
        ++all;
        backs += hit->back ? 1 : 0;
      }
  REQUIRE(all > 0);
  return static_cast<double>(backs) / all;
}

struct Counts {
  std::size_t triangles, dropped, objects, textures;
};

void checkCounts(const geometry::Surfaces& s, const Counts& must) {
  CHECK(s.triangle.size() == must.triangles);
  CHECK(s.dropped_triangles == must.dropped);
  CHECK(s.object.size() == must.objects);
  CHECK(s.texture.size() == must.textures);
}

}  // namespace

TEST_CASE("RealLevels, TruckTownHasItsWebpTexturesAndItsFrontsUp") {
  const auto s = read("truck_town/town/model/town_model.gltf");
  if (!s) return;
  checkCounts(*s, {30341, 136, 20, 2});
  checkBounds(*s, {-1024, -4.64, -1024}, {1024, 17.7564, 1024});
  CHECK(s->texture[0].width == 1024);
  CHECK(s->file.size() == 4);
  CHECK(shareOfBacks(*s, 100.0, 1.0) == 0.0);
}

TEST_CASE("RealLevels, TreesHaveLeavesWithHoles") {
  const auto s = read("truck_town/town/tree/scene.gltf", 0.01);
  if (!s) return;
  checkCounts(*s, {778, 0, 2, 2});
  checkBounds(*s, {-8.42152, 0, -9.44366}, {9.1026, 24.7055, 8.51508});
  CHECK(s->warning.empty());
  geometry::Surfaces opaque = *s;
  for (geometry::Material& m : opaque.material) m.alpha_cutoff = 0.0;
  const geometry::Tracer holes(*s);
  const geometry::Tracer whole(opaque);
  int through = 0;
  for (double x = -8.0; x < 8.0; x += 0.25) {
    const bool is = holes.closest({x, 17.0, 50.0}, {0.0, 0.0, -1.0}, 100.0).has_value();
    const bool would_be = whole.closest({x, 17.0, 50.0}, {0.0, 0.0, -1.0}, 100.0).has_value();
    CHECK((would_be || !is));
    through += would_be && !is ? 1 : 0;
  }
  CHECK(through > 0);
}

TEST_CASE("RealLevels, ObjMapsWithoutTheirImagesHaveTheLevelsAlbedo") {
  struct Map {
    const char* file;
    Counts counts;
    Number3 low, high;
    const char* missing;
  };
  const Map maps[] = {
      {"redeclipse/fortitude.obj", {48321, 37, 119, 0}, {-128, 0, -128}, {128, 124.5, 128}, "38 images"},
      {"test_ctf/test_ctf.obj", {11413, 0, 27, 0}, {-62, 0, -42}, {62, 34, 42}, "11 images"}};
  for (const Map& map : maps) {
    const auto s = read(map.file, 0.125);
    if (!s) return;
    checkCounts(*s, map.counts);
    checkBounds(*s, map.low, map.high);
    REQUIRE_FALSE(s->warning.empty());
    CHECK_THAT(s->warning[0], Catch::Contains(map.missing));
    for (const geometry::Material& m : s->material) checkNear(m.albedo, Number3(0.5), 0);
  }
  CHECK(shareOfBacks(*read("test_ctf/test_ctf.obj", 0.125), 60.0, 1.0) == 0.0);
}

TEST_CASE("RealLevels, BinaryFilesOfACityKit") {
  const auto s = read("kenney_city/models/building-small-a.glb");
  if (!s) return;
  checkCounts(*s, {440, 12, 1, 1});
  checkBounds(*s, {-0.5, 0, -0.5}, {0.5, 0.95, 0.5});
  const geometry::Tracer tracer(*s);
  const auto roof = below(tracer, 0.11, 0.13);
  REQUIRE(roof);
  const Number3 albedo = tracer.albedo(*roof);
  CHECK(albedo.x + albedo.y + albedo.z > 0.0);
}

}  // namespace welkin::tests
