// SPDX-License-Identifier: Apache-2.0
// level.toml: its values, and messages about errors.
#include "probes/level/level_file.h"

#include <catch2/catch.hpp>

#include "sky/base/error.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {
using f64::Number3;

void checkLevelRefused(const std::string& text, base::ExitStatus status, const std::string& says) {
  const Folder folder;
  const std::string path = folder.write("level.toml", text);
  INFO(text);
  try {
    level::levelFileOf(base::readToml(path));
    FAIL("it was read");
  } catch (const base::Error& e) {
    CHECK(e.status() == status);
    CHECK_THAT(e.what(), Catch::Contains("level.toml") && Catch::Contains(says));
  }
}

constexpr const char* kLevel = "[level]\nsky = \"sky.toml\"\n";

}  // namespace

TEST_CASE("LevelFile, GivesGeometryAndLeavesTheBakesTablesAlone") {
  const Folder folder;
  const level::LevelFile file = level::levelFileOf(base::readToml(folder.write("a/level.toml", std::string(kLevel) + R"(
[[geometry]]
file = "terrain.gltf"
translation = [1, 2, 3]
rotation_deg = [90, 90, 0]
scale = [2, 3, 4]
role = "vegetation"
vegetation_nodes = ["palm*"]
ignore_nodes = ["sky*", "UCX_*"]
albedo = [0.1, 0.2, 0.3]
[[geometry]]
file = "hut.glb"
scale = 2
[probes]
spacing_m = 4.0
what_a_later_version_has = 1
[transfer]
rays = "auto"
[scale]
sky = 1.0
)")));
  CHECK(file.sky == folder.path() / "a" / "sky.toml");
  REQUIRE(file.geometry.size() == 2);
  const level::GeometryEntry& g = file.geometry[0];
  CHECK(g.path == folder.path() / "a" / "terrain.gltf");
  CHECK(g.role == geometry::Role::vegetation);
  CHECK(g.vegetation_nodes == std::vector<std::string>{"palm*"});
  CHECK(g.ignore_nodes == std::vector<std::string>{"sky*", "UCX_*"});
  CHECK(g.albedo == Number3(0.1, 0.2, 0.3));
  // x comes first: +y turns to +z, +z to -y. Then y: +z turns to +x, +x to -z. Scaling comes before, translation after.
  const auto check = [](const Number3& is, const Number3& must) {
    for (int i = 0; i < 3; ++i) CHECK(is[i] == Approx(must[i]).margin(1e-12));
  };
  check(g.transform.point({0, 0, 0}), {1, 2, 3});
  check(g.transform.linear({1, 0, 0}), {0, 0, -2});
  check(g.transform.linear({0, 1, 0}), {3, 0, 0});
  check(g.transform.linear({0, 0, 1}), {0, -4, 0});
  CHECK(file.geometry[1].transform.determinant() == Approx(8.0));
  CHECK(file.geometry[1].role == geometry::Role::fixed);
  CHECK(file.geometry[1].albedo == Number3(0.5));
}

TEST_CASE("LevelFile, MessagesNameTheKeyAndWhatIsAllowed") {
  const std::string geometry = "[[geometry]]\nfile = \"a.gltf\"\n";
  const std::string level = kLevel;
  checkLevelRefused(level + geometry + "rol = \"static\"\n", base::ExitStatus::content,
                    "nearest known one is \"role\"");
  checkLevelRefused(level + geometry + "role = \"water\"\n", base::ExitStatus::content, "must be one of");
  checkLevelRefused(level + geometry + "scale = 0\n", base::ExitStatus::content, "scale");
  checkLevelRefused(level + geometry + "scale = [1, 2]\n", base::ExitStatus::content, "scale");
  checkLevelRefused(level + geometry + "albedo = [0.1, 0.2, 1.3]\n", base::ExitStatus::content, "albedo");
  checkLevelRefused(level + geometry + "translation = [1, 2, nan]\n", base::ExitStatus::content, "translation");
  checkLevelRefused(level + geometry + "vegetation_nodes = [1]\n", base::ExitStatus::content, "vegetation_nodes");
  checkLevelRefused(level + geometry + "ignore_nodes = \"sky\"\n", base::ExitStatus::content, "ignore_nodes");
  checkLevelRefused(level + geometry + "[probs]\n", base::ExitStatus::content, "nearest known one is \"probes\"");
  checkLevelRefused(level + "[[geometry]]\n", base::ExitStatus::content, "geometry[0].file");
  checkLevelRefused(level, base::ExitStatus::content, "geometry");
  checkLevelRefused(level + "geometry = 1\n", base::ExitStatus::content, "geometry");
  checkLevelRefused("[level]\n" + geometry, base::ExitStatus::content, "level.sky");
  checkLevelRefused(level + "probes = 1\n" + geometry, base::ExitStatus::content, "level.probes");
  checkLevelRefused("probes = 1\n" + level + geometry, base::ExitStatus::content, "must be a table");
  checkLevelRefused("[level", base::ExitStatus::content, "not TOML");
}

TEST_CASE("LevelFile, MissingIsARefusalOfTheSystem") {
  const Folder folder;
  try {
    level::levelFileOf(base::readToml(folder / "level.toml"));
    FAIL("it was read");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::file);
  }
}

}  // namespace welkin::tests
