// SPDX-License-Identifier: Apache-2.0
// Files outside of a level's folder: a warning, or refused, and no byte of them in a message.
#include <regex>

#include "level_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

const std::string kSecret = "root:x:0:0:secret:/root:/bin/sh\n";

}  // namespace

TEST_CASE("Outside, AFileBesideTheLevelIsWarnedOfAllowedOrRefused") {
  const Folder folder;
  folder.write("sky.toml", skyText(kUniform));
  GltfText model;
  model.addNode(model.addMesh(squareMesh()));
  folder.write("a.gltf", model.text());
  folder.write("level/a.gltf", model.text());
  folder.write("level/sky.toml", skyText(kUniform));
  const auto plan = [&](const std::string& rule, const std::string& sky, const std::string& file) {
    const std::string level = folder.write(
        "level/level.toml", "[level]\nsky = \"" + sky + "\"\n" + rule + "\n[[geometry]]\nfile = \"" + file + "\"\n");
    return runTool({"plan", level, "--progress", "none"});
  };
  fs::create_symlink(folder / "a.gltf", folder / "level/link.gltf");
  for (const auto& [sky, file] : {std::pair<std::string, std::string>("../sky.toml", "a.gltf"),
                                  {"sky.toml", "../a.gltf"},
                                  {"sky.toml", "link.gltf"},
                                  {"sky.toml", folder / "a.gltf"}}) {
    INFO(sky << " " << file);
    const Run warned = plan("", sky, file);
    REQUIRE(warned.status == 0);
    REQUIRE(warned.said("warning: reads files outside of the level's folder: "));
    const Run allowed = plan("outside_files = \"allow\"", sky, file);
    REQUIRE(allowed.status == 0);
    REQUIRE(allowed.err.empty());
    const Run refused = plan("outside_files = \"refuse\"", sky, file);
    REQUIRE(refused.status == 3);
    REQUIRE(refused.said("level.outside_files = \"refuse\": the level reads files outside of the level's folder: "));
  }
  const Run inside = plan("outside_files = \"refuse\"", "../level/sky.toml", "./a.gltf");
  REQUIRE(inside.status == 0);
  REQUIRE(inside.err.empty());
  REQUIRE(plan("outside_files = \"no\"", "sky.toml", "a.gltf").said("level.outside_files"));
}

TEST_CASE("Outside, NoByteOfSuchAFileIsInAMessage") {
  std::string secret;
  while (secret.size() < 4096) secret += kSecret;
  const Folder folder;
  folder.write("secret", secret);
  folder.write("level/sky.toml", skyText(kUniform));
  GltfText model;
  model.addNode(model.addMesh(squareMesh()));
  nlohmann::json text = nlohmann::json::parse(model.text());
  text["buffers"] = {{{"uri", "../secret"}, {"byteLength", secret.size()}}};  // as positions and as indices
  folder.write("level/a.gltf", text.dump());
  const auto plan = [&](const std::string& rule) {
    const std::string level = folder.write(
        "level/level.toml", "[level]\nsky = \"sky.toml\"\n" + rule + "\n[[geometry]]\nfile = \"a.gltf\"\n");
    return runTool({"plan", level, "--progress", "none"});
  };
  const auto shows = [&](const Run& run) {  // text as a float is past 1e20, as indices of 16 bits past 8000
    const std::string said = std::regex_replace(run.err, std::regex(folder.path().string()), "");
    return std::regex_search(said, std::regex("e\\+[0-9]|root|secret:|[0-9]{4}"));
  };
  const Run warned = plan("");
  INFO(warned.err);
  REQUIRE(warned.status == 3);
  REQUIRE(
      warned.said("a.gltf: it, or a file that it names, is wrong; its words are left out, as it reads files outside"));
  REQUIRE_FALSE(shows(warned));
  const Run refused = plan("outside_files = \"refuse\"");
  REQUIRE(refused.said("outside_files = \"refuse\""));
  REQUIRE_FALSE(shows(refused));
  REQUIRE(shows(plan("outside_files = \"allow\"")));
}

TEST_CASE("Outside, NoWordOfSuchALibraryIsInAWarning") {
  const Folder folder;
  folder.write("secret", kSecret);
  folder.write("level/sky.toml", skyText(kUniform));
  const std::string square = "v -3 0 -3\nv -3 0 3\nv 3 0 3\nv 3 0 -3\nf 1 2 3 4\n";
  const auto plan = [&](const std::string& rule, const std::string& faces) {
    folder.write("level/a.obj", "mtllib ../secret\n" + faces);
    const std::string level =
        folder.write("level/level.toml", "[level]\nsky = \"sky.toml\"\n" + rule + "\n[[geometry]]\nfile = \"a.obj\"\n");
    return runTool({"plan", level, "--progress", "none"});
  };
  const Run warned = plan("", square);
  INFO(warned.err);
  REQUIRE(warned.status == 0);
  REQUIRE(
      warned.said("secret: not read: keywords that are left out here, as the file is outside of the level's folder"));
  REQUIRE_FALSE(warned.said("root"));
  const Run empty = plan("", "");
  REQUIRE(empty.status == 3);
  REQUIRE_FALSE(empty.said("root"));
  REQUIRE(plan("outside_files = \"allow\"", square).said("root:x:0:0:secret:/root:/bin/sh (line 1)"));
}
