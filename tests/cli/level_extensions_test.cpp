// SPDX-License-Identifier: Apache-2.0
// Every command that reads a level names the extensions of glTF that it does not read.
#include "level_text.h"

using namespace welkin::tests;

TEST_CASE("LevelExtensions, EveryCommandNamesThem") {
  const SmallLevel level;
  GltfText model;
  model.addNode(model.addMesh(squareMesh(), model.addMaterial({0.5, 0.5, 0.5})), {{"scale", {30, 1, 30}}});
  model.json["materials"][0]["extensions"] = {{"VENDOR_magic", nlohmann::json::object()},
                                              {"KHR_materials_ior", nlohmann::json::object()}};
  std::ofstream(level / "level.gltf", std::ios::binary) << model.text();
  const std::string says = "level.gltf: VENDOR_magic is not read: materials[0]";
  const std::vector<std::vector<std::string>> commands = {
      {"validate", level / "level.toml"},
      {"plan", level / "level.toml", "--progress", "none"},
      {"reference", level / "level.toml", "--time", "12", "--position", "0,1,0", "--normal", "0,1,0", "--samples", "64",
       "--progress", "none"},
      level.command("out")};
  for (const auto& command : commands) {
    const Run run = runTool(command);
    INFO(command[0] << ": " << run.err);
    CHECK(run.status == 0);
    CHECK(run.said("welkin: warning: " + (level / says)));
    CHECK_FALSE(run.said("KHR_materials_ior"));
  }
  CHECK(readBytes(level / "out/report.json").find(says) != std::string::npos);
  model.json["extensionsRequired"] = {"VENDOR_magic"};
  std::ofstream(level / "level.gltf", std::ios::binary) << model.text();
  for (const auto& command : commands) {
    const Run run = runTool(command);
    INFO(command[0] << ": " << run.err);
    CHECK(run.status == 3);
    CHECK(run.said("extensionsRequired: \"VENDOR_magic\" is not read"));
  }
}
