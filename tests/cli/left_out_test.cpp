// SPDX-License-Identifier: Apache-2.0
// Parts that a sky does not need. Plan and report name them with the bytes saved, and the certified error shows no
// trace of them.
#include <catch2/catch.hpp>
#include <map>
#include <string>

#include "baked.h"
#include "tests/gltf_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

const std::string kLeftSmall = "bands = 3\nkeys = 6\ncubemap_size = 0\nencoding = \"float32\"";
constexpr double kLeftQuadrature = 2e-5;  // Relative to the mean: two bakes whose moments are kept to 1e-5.

struct Baked {
  std::map<std::string, json> left_out;
  json report;
  double error() const { return report["certificate"]["max_error"]; }
  bool leavesOut(const std::string& what) const { return left_out.contains(what); }
};

/// A bake whose plan and report agree.
Baked bake(const std::string& text, const std::vector<std::string>& more = {}) {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", text);
  Baked baked{{}, bakeReport(sky, folder / "out", more)};
  std::vector<std::string> arguments = {"plan", sky, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  REQUIRE(printedJson(arguments)["left_out"] == baked.report["left_out"]);
  arguments[2] = "--progress=none";
  const std::string shown = runTool(arguments).out;
  for (const json& l : baked.report["left_out"]) {
    INFO(l.dump());
    REQUIRE_FALSE(l["why"].get<std::string>().empty());
    REQUIRE(l["bytes"] >= 0);
    REQUIRE(l["evaluations"] >= 0.0);
    REQUIRE(shown.find("left out   " + l["what"].get<std::string>() + ": ") != std::string::npos);
    baked.left_out[l["what"]] = l;
  }
  return baked;
}

}  // namespace

TEST_CASE("LeftOut, TwoChannelsOfAGreySky") {
  const Baked grey = bake(skyText(kDay, kDaySun, kLeftSmall));
  REQUIRE(grey.report["table"]["channels"] == 1);
  REQUIRE(grey.left_out.at("two of three channels")["bytes"] == 2 * 6 * 6 * 4);  // numbers of a key, keys, floats
  // One colour at every hour and height. Each channel is a multiple of the grey sky, and red, the brightest, has its
  // error.
  const Baked orange =
      bake(skyText(kDay + "\ngradient_sun = [1.0, 0.5, 0.25]\ngradient_anti = [1.0, 0.5, 0.25]", kDaySun, kLeftSmall));
  REQUIRE(orange.report["table"]["channels"] == 3);
  REQUIRE_FALSE(orange.leavesOut("two of three channels"));
  REQUIRE(orange.error() == Approx(grey.error()).margin(kLeftQuadrature));
}

TEST_CASE("LeftOut, CoefficientsOfASymmetricSky") {
  const Baked sky = bake(skyText(kDay, kDaySun, kLeftSmall));
  REQUIRE(sky.left_out.at("3 of 9 coefficients")["bytes"] == 3 * 6 * 4);
  REQUIRE(sky.report["table"]["numbers_of_key"] == 6);
}

TEST_CASE("LeftOut, HorizontalIrradianceOfABlackGround") {
  const Baked black = bake(skyText(kDay, kDaySun, kLeftSmall));
  REQUIRE(black.left_out.at("horizontal irradiance")["bytes"] == 6 * 4);
  const Baked nearly = bake(skyText(kDay + "\nground_albedo = [1e-7, 1e-7, 1e-7]", kDaySun, kLeftSmall));
  REQUIRE_FALSE(nearly.leavesOut("horizontal irradiance"));
  REQUIRE(nearly.report["table"]["bytes"] == black.report["table"]["bytes"].get<int>() + 6 * 4);
  REQUIRE(nearly.error() == Approx(black.error()).margin(kLeftQuadrature));
}

TEST_CASE("LeftOut, MoonAndStars") {
  const Baked dark = bake(skyText(kDay, kDaySun, kLeftSmall));
  REQUIRE(dark.leavesOut("moon"));
  REQUIRE(dark.leavesOut("stars"));
  const Baked moonlit = bake(skyText(kDay, kDaySun, kLeftSmall) + "[moon]\npath = [[0, 180, 50], [12, 0, -50]]\n");
  REQUIRE_FALSE(moonlit.leavesOut("moon"));
  REQUIRE(moonlit.error() == dark.error());
}

TEST_CASE("LeftOut, CubemapsOfASkyThatNothingReflects") {
  const Baked none = bake(skyText(kDay, kDaySun, kLeftSmall));
  REQUIRE(none.left_out.at("cubemaps")["bytes"] > 0);
  REQUIRE(none.left_out.at("cubemaps")["evaluations"] > 0.0);
  const Baked some = bake(skyText(kDay, kDaySun, "bands = 3\nkeys = 6\nencoding = \"float32\"\ncubemap_size = 4"));
  REQUIRE_FALSE(some.leavesOut("cubemaps"));
  REQUIRE(some.error() == none.error());
}

TEST_CASE("LeftOut, CubemapsOfALevelThatReflectsNothing") {
  const std::string sky = skyText(kDay, kDaySun, "bands = 2\nkeys = 4");
  const auto levelOf = [&](const Folder& folder, double roughness, const std::string& sky_text) {
    GltfText model;
    const int material = model.addMaterial({0.5, 0.5, 0.5});
    model.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = roughness;
    model.addNode(model.addMesh(squareMesh(), material));
    folder.write("ground.gltf", model.text());
    folder.write("sky.toml", sky_text);
    return folder.write("level.toml", "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"ground.gltf\"\n");
  };
  const auto cubemapsOf = [&](double roughness, const std::string& sky_text) {
    const Folder folder;
    const json plan = printedJson({"plan", levelOf(folder, roughness, sky_text), "--json"});
    std::string why;
    for (const auto& left_out : plan["left_out"])
      if (left_out["what"] == "cubemaps") why = left_out["why"];
    return std::pair(plan["cubemaps"]["count"].get<int>(), why);
  };
  REQUIRE(cubemapsOf(0.1, sky) == std::pair(8, std::string()));
  const auto [count, why] = cubemapsOf(0.9, sky);
  REQUIRE(count == 0);
  REQUIRE(why.find("level") != std::string::npos);
  REQUIRE(cubemapsOf(0.9, sky + "cubemap_size = 4\n").first == 8);  // Requested by the file.
  const Folder folder;
  const std::string level = levelOf(folder, 0.9, sky);
  const json report = bakeReport(level, folder / "out", {"--certify", "none"});
  REQUIRE(report["cubemaps"]["size"] == 0);
  std::vector<std::string> names;
  for (const auto& input : report["inputs"]) names.push_back(input["name"]);
  REQUIRE(names == std::vector<std::string>{"sky.toml", "level.toml", "ground.gltf"});
}

TEST_CASE("LeftOut, KeysOfASkyThatStandsStill") {
  const std::string fixed = "cubemap_size = 0\nbands = 2\nreconstruction = \"projected\"\nencoding = \"float32\"";
  const std::vector<std::string> budget = {"--max-error", "0.9"};
  const Baked still = bake(skyText(kDay, kStillSun, fixed), budget);
  REQUIRE(still.report["table"]["keys"] == 1);
  REQUIRE(still.left_out.at("287 keys")["bytes"] == 287 * (3 * 4 + 8));  // the numbers of a key and its time
  const Baked all = bake(skyText(kDay, kStillSun, fixed + "\nkeys = 288"), budget);
  REQUIRE(all.report["table"]["keys"] == 288);
  REQUIRE_FALSE(all.leavesOut("287 keys"));
  REQUIRE(still.error() == Approx(all.error()).margin(kLeftQuadrature));
  const Baked moving = bake(skyText(kDay, kDaySun, fixed), budget);
  REQUIRE_FALSE(moving.leavesOut("287 keys"));
}

TEST_CASE("LeftOut, AnOvercastSkyTakesFewNumbers") {
  const std::string budget = "cubemap_size = 0\nmax_error = 0.03";
  const Baked overcast = bake(skyText("luminance = \"cie-overcast\"\nnormalise = \"zenith\"", kDaySun, budget));
  const Baked clear = bake(skyText(kDay, kDaySun, budget));
  REQUIRE(overcast.report["table"]["keys"] == 1);
  REQUIRE(overcast.report["table"]["bytes"] < clear.report["table"]["bytes"]);
  REQUIRE(overcast.error() <= 0.03);
}
