// SPDX-License-Identifier: Apache-2.0
// validate accepts what a bake accepts, and compares every file with each checksum that is recorded of it.
#include "baked.h"
#include "level_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

Run validate(const std::string& path) {
  return runTool({"validate", path});
}

/// Requires the folder to be refused with every one of its files damaged, and with every one of another folder's.
void requireEachFileChecked(const fs::path& out, const fs::path& other) {
  REQUIRE(validate(out.string()).status == 0);
  int checked = 0;
  for (const auto& name : filesUnder(out)) {
    if (name == "timing.json") continue;
    INFO(name);
    const std::string path = (out / name).string();
    const std::string bytes = readBytes(path);
    const std::string digits = "\"bytes\": ";
    const std::size_t digit = bytes.find(digits);
    flipBit(path, name.ends_with(".json") ? digit + digits.size() : bytes.size() / 2);
    REQUIRE(validate(out.string()).status == 3);
    std::ofstream(path, std::ios::binary) << readBytes(other / name);
    REQUIRE(validate(out.string()).status == 3);
    std::ofstream(path, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    REQUIRE(validate(out.string()).status == 3);
    fs::remove(path);
    const int status = validate(out.string()).status;
    REQUIRE(status == (name.ends_with(".json") || name == "level.welkin" ? status : 2));
    std::ofstream(path, std::ios::binary) << bytes;
    ++checked;
  }
  REQUIRE(checked > 4);
  REQUIRE(validate(out.string()).status == 0);
}

}  // namespace

TEST_CASE("Validate, ASkysFilesAreOfOneBakeAndWhole") {
  const Folder folder;
  const std::string bake = "keys = 2\ncubemap_size = 4\ncubemap_times = [0, 12]";
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, bake));
  REQUIRE(runBake(sky, folder / "out").status == 0);
  folder.write("sky.toml", skyText(kDay + "\nintensity = 2", kDaySun, bake));
  REQUIRE(runBake(sky, folder / "other").status == 0);
  requireEachFileChecked(folder / "out", folder / "other");
}

TEST_CASE("Validate, ALevelsFilesAreOfOneBakeAndWhole") {
  const SmallLevel level(64);
  level.bake("out");
  level.writeSky(50.0);
  level.writeHut(60.0);
  level.writeLevel("rays = 72");
  level.bake("other");
  requireEachFileChecked(level.path() / "out", level.path() / "other");
}

TEST_CASE("Validate, RefusesTheLevelsThatABakeRefuses") {
  const SmallLevel level(64);
  const auto requireSame = [&](const std::string& part) {
    const Run bake = runTool(level.command("out"));
    const Run checked = validate(level / "level.toml");
    INFO(bake.err << checked.err);
    REQUIRE(bake.status == 3);
    REQUIRE(checked.status == 3);
    REQUIRE(checked.err == bake.err);
    REQUIRE(checked.said(part));
    REQUIRE_FALSE(fs::exists(level / "out"));
  };
  level.writeLevel("rays = \"auto\"");
  requireSame("needs a budget");
  std::string rooms;
  for (int i = 0; i < 256; ++i)
    rooms += "[[room]]\nbox = [1, " + std::to_string(i) + ", 1, 2, " + std::to_string(i) + ".5, 2]\n";
  level.writeLevel("rays = 64", rooms);
  requireSame("[[room]]: 256 touch sector 0_0; at most 254 may");
  GltfText plane;
  plane.addNode(plane.addMesh(squareMesh()), {{"scale", {1e5, 1, 1e5}}});
  std::ofstream(level / "level.gltf") << plane.text();
  level.writeLevel("rays = 64");
  requireSame("sectors of 64 m; at most");
}
