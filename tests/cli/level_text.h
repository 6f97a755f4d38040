// SPDX-License-Identifier: Apache-2.0
// A level for the command line with four sectors in a row, -1_0 to 2_0: ground and a hut.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "run_tool.h"
#include "sky_text.h"
#include "tests/gltf_text.h"

namespace welkin::tests {

class SmallLevel {
 public:
  explicit SmallLevel(int rays = 64) {
    writeHut(170.0);
    writeSky(60.0);
    writeLevel("rays = " + std::to_string(rays));
  }

  /// `lamp_x` is the position of a point light, if there is one.
  void writeHut(double x, std::optional<double> lamp_x = std::nullopt) const {
    GltfText model;
    model.addNode(model.addMesh(squareMesh()), {{"translation", {64, 0, 32}}, {"scale", {127, 1, 31}}});
    model.addNode(model.addMesh(boxMesh()), {{"translation", {x, 2, 30}}, {"scale", {2, 2, 2}}});
    if (lamp_x) model.addPointLight({*lamp_x, 3, 32});
    folder_.write("level.gltf", model.text());
  }
  void writeSky(double noon_deg, const std::string& more = "") const {
    folder_.write("sky.toml", skyText(kUniform + "\n" + more, "path = [[0, 0, -30], [6, 90, 0], [12, 180, " +
                                                                  std::to_string(noon_deg) + "], [18, 270, 0]]"));
  }
  void writeLevel(const std::string& transfer, const std::string& more = "") const {
    folder_.write("level.toml",
                  "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"level.gltf\"\n[probes]\nspacing_m = 16\n" +
                      more + "\n[transfer]\n" + transfer +
                      (transfer.find("reach_m") == std::string::npos ? "\nreach_m = 64\n" : "\n"));
  }

  std::string operator/(const std::string& name) const { return folder_ / name; }
  std::filesystem::path path() const { return folder_.path(); }

  std::vector<std::string> command(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"bake", *this / "level.toml", "-o",  *this / out, "--progress",
                                      "none", "--certify",          "none"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Number of sectors that a bake into `out` bakes.
  int bake(const std::string& out, const std::vector<std::string>& more = {}) const {
    const Run run = runTool(command(out, more));
    if (run.status != 0) throw std::runtime_error(run.err);
    return nlohmann::json::parse(readBytes(*this / (out + "/timing.json")))["sectors_baked"];
  }

 private:
  Folder folder_;
};

inline constexpr int kSectors = 4;

/// Requires the files of two folders to be equal, except for the costs of a run and the part of them that concerns
/// shards.
inline void requireSame(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::size_t compared = 0;
  for (const auto& name : filesUnder(a)) {
    if (std::filesystem::path(name).extension() == ".json") continue;
    INFO(name);
    REQUIRE(readBytes(a / name) == readBytes(b / name));
    ++compared;
  }
  REQUIRE(compared == kSectors + 2);
}

}  // namespace welkin::tests
