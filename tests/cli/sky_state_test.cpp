// SPDX-License-Identifier: Apache-2.0
// A sky that is up to date is not baked again. It counts as up to date only if a fresh bake would give the same files.
#include <xxhash.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "baked.h"
#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kUncertified = {"--certify", "none"};
const std::string kCubemap = "cubemaps/sky_120000000_latlong.exr";

/// Requires two folders to be equal, except for the times of a bake.
void requireSameFolder(const fs::path& a, const fs::path& b) {
  REQUIRE(filesUnder(a) == filesUnder(b));
  for (const auto& name : filesUnder(a)) {
    INFO(name);
    if (name != "timing.json") REQUIRE(readBytes(a / name) == readBytes(b / name));
  }
}

/// A sky of two painted gradients and two cubemaps, baked into `out`.
class BakedSky {
 public:
  BakedSky() {
    REQUIRE(runTool({"init", folder_ / "in"}).status == 0);
    writeSky("");
    bake("out");
  }

  const Folder& folder() const { return folder_; }
  std::string out(const std::string& name) const { return folder_ / ("out/" + name); }
  void writeSky(const std::string& more) const {
    folder_.write(
        "in/sky.toml",
        skyText(kUniform + "\ngradient_sun = \"gradient_sun.png\"\ngradient_anti = \"gradient_anti.png\"\n" + more,
                kDaySun, "bands = 2\nkeys = 24\ncubemap_size = 4\ncubemap_times = [0, 12]"));
  }

  /// Returns whether the bake into the folder baked the sky. `said` receives its stderr.
  bool bake(const std::string& to, const std::vector<std::string>& more = kUncertified,
            std::string* said = nullptr) const {
    const Run run = runBake(folder_ / "in/sky.toml", folder_ / to, more);
    INFO(run.err);
    REQUIRE(run.status == 0);
    if (said != nullptr) *said = run.err;
    return json::parse(readBytes(folder_ / (to + "/timing.json")))["sky_baked"];
  }
  json plan(const std::vector<std::string>& more = kUncertified, bool of_folder = true) const {
    std::vector<std::string> words = {"plan", folder_ / "in/sky.toml", "--json"};
    if (of_folder) words.insert(words.end(), {"-o", folder_ / "out"});
    words.insert(words.end(), more.begin(), more.end());
    return printedJson(words);
  }

  /// Requires the sky to be out of date. Baking it must equal a fresh bake, after which it is up to date.
  void requireBakes(const std::string& why, const std::vector<std::string>& more = kUncertified) const {
    const json sky = plan(more)["sky"];
    REQUIRE(sky["why"] == why);
    REQUIRE(sky["bake"] == true);
    REQUIRE(bake("out", more));
    fs::remove_all(folder_ / "nothing");
    REQUIRE(bake("nothing", more));
    requireSameFolder(folder_ / "out", folder_ / "nothing");
    REQUIRE(plan(more)["sky"]["why"] == "up to date");
    REQUIRE_FALSE(bake("out", more));
    requireSameFolder(folder_ / "out", folder_ / "nothing");
  }

 private:
  Folder folder_;
};

/// Writes a record with other content and a matching checksum.
void writeRecord(const std::string& path, ordered_json record) {
  record.erase("xxh3_128");
  const std::string text = record.dump();
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  char checksum[33];
  std::snprintf(checksum, sizeof checksum, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  record["xxh3_128"] = checksum;
  std::ofstream(path, std::ios::binary) << record;
}

}  // namespace

TEST_CASE("SkyState, WhatIsUpToDateIsLeftAloneAndReportedTheSame") {
  const BakedSky sky;
  std::string first, second;
  REQUIRE(sky.bake("fast", {}, &first));
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (const auto& name : filesUnder(sky.folder() / "fast"))
    fs::last_write_time(sky.folder().path() / "fast" / name, long_ago);
  const auto date = fs::last_write_time(sky.folder() / "fast/sky.welkin");
  fs::copy(sky.folder() / "fast", sky.folder() / "copy", fs::copy_options::recursive);
  fs::remove(sky.folder() / "fast/report.json");
  REQUIRE_FALSE(sky.bake("fast", {"--threads", "1", "--depfile", sky.folder() / "d"}, &second));
  REQUIRE(second == first);
  REQUIRE(first.find("irradiance within") != std::string::npos);
  requireSameFolder(sky.folder() / "fast", sky.folder() / "copy");
  for (const auto& name : filesUnder(sky.folder() / "fast"))
    if (name != "timing.json" && name != "report.json")
      REQUIRE(fs::last_write_time(sky.folder().path() / "fast" / name) == date);
  REQUIRE(readBytes(sky.folder() / "d").find("gradient_anti.png") != std::string::npos);
  REQUIRE(sky.bake("fast", {"--force"}));
  requireSameFolder(sky.folder() / "fast", sky.folder() / "copy");
}

TEST_CASE("SkyState, APlanFromTheRecordIsThePlan") {
  const BakedSky sky;
  json of_nothing = sky.plan(kUncertified, false);
  json of_record = sky.plan();
  REQUIRE(of_nothing["sky"] == json({{"bake", true}, {"why", "missing"}}));
  REQUIRE(of_record["sky"] == json({{"bake", false}, {"why", "up to date"}}));
  of_nothing.erase("sky");
  of_record.erase("sky");
  REQUIRE(of_nothing == of_record);
  const Run run = runTool({"plan", sky.folder() / "in/sky.toml", "-o", sky.folder() / "out", "--certify", "none"});
  REQUIRE(run.status == 0);
  REQUIRE(run.err.empty());  // no progress: nothing is planned
  REQUIRE(run.out.find(" bytes  up to date\n") != std::string::npos);
}

TEST_CASE("SkyState, AnotherInputIsBaked") {
  const BakedSky sky;
  fs::copy_file(sky.folder() / "in/gradient_anti.png", sky.folder() / "in/gradient_sun.png",
                fs::copy_options::overwrite_existing);
  sky.requireBakes("changed: gradient_sun.png");
  sky.writeSky("ground_albedo = [0.2, 0.3, 0.4]");
  sky.requireBakes("changed: sky.toml");
  sky.writeSky("# as grass\nground_albedo = [0.2,  0.3, 0.4]");  // the same settings
  REQUIRE(sky.plan()["sky"]["why"] == "up to date");
  REQUIRE_FALSE(sky.bake("out"));
  std::string text = readBytes(sky.folder() / "in/sky.toml");
  text.replace(text.find("cie-5"), 5, "cie-4");
  sky.folder().write("in/sky.toml", text);
  sky.requireBakes("changed: sky.toml");
  text.replace(text.find("\"gradient_sun.png\""), 18, "\"gradient_anti.png\"");
  sky.folder().write("in/sky.toml", text);
  sky.requireBakes("changed: sky.toml, gradient_anti.png, gradient_sun.png");
}

TEST_CASE("SkyState, AnotherRequestIsBaked") {
  const BakedSky sky;
  sky.requireBakes("changed: max_error", {"--max-error", "0.9", "--certify", "none"});
  sky.requireBakes("changed: max_error", {"--max-error", "0.8", "--certify", "none"});
  sky.requireBakes("changed: max_error, certify", {});
  sky.requireBakes("changed: certify");
}

TEST_CASE("SkyState, AnotherToolsSkyIsBaked") {
  const BakedSky sky;
  ordered_json record = ordered_json::parse(readBytes(sky.out("sky.json")));
  writeRecord(sky.out("sky.json"), record);  // Only white space differs.
  REQUIRE_FALSE(sky.bake("out"));
  record["request"]["method"] = record["request"]["method"].get<int>() + 1;
  writeRecord(sky.out("sky.json"), record);
  sky.requireBakes("changed: method");
  std::string bytes = readBytes(sky.out("sky.welkin"));
  bytes[8] = 1;  // the header's version
  std::ofstream(sky.out("sky.welkin"), std::ios::binary) << bytes;
  REQUIRE(sky.plan()["sky"]["why"].get<std::string>().starts_with(
      "unreadable: it is a sky of version 1; this program reads "));
  REQUIRE(sky.bake("out"));
}

TEST_CASE("SkyState, DamagedAndMissingFilesAreBakedAgain") {
  const BakedSky sky;
  flipBit(sky.out("sky.welkin"), 200);
  sky.requireBakes("unreadable: it is damaged: its checksum does not fit");
  std::ofstream(sky.out("sky.welkin"), std::ios::binary) << "text";
  sky.requireBakes("unreadable: it is not a .welkin file");
  fs::remove(sky.out("sky.welkin"));
  sky.requireBakes("missing");
  const std::string record = readBytes(sky.out("sky.json"));
  flipBit(sky.out("sky.json"), record.find("\"evaluations\": ") + 15);  // a digit of the report
  sky.requireBakes("unreadable: sky.json");
  for (const std::string& bytes :
       {std::string("{"), std::string("[]"), std::string("{\"xxh3_128\": 1}"), record + "}"}) {
    std::ofstream(sky.out("sky.json"), std::ios::binary) << bytes;
    REQUIRE(sky.plan()["sky"]["why"] == "unreadable: sky.json");
  }
  fs::remove(sky.out("sky.json"));
  sky.requireBakes("missing: sky.json");
  fs::remove(sky.out(kCubemap));
  sky.requireBakes("missing: " + kCubemap);
  flipBit(sky.out(kCubemap), 500);
  sky.requireBakes("changed: " + kCubemap);
}

TEST_CASE("SkyState, AForgedRecordIsNoRecord") {
  const BakedSky sky;
  REQUIRE(sky.bake("out", {}));
  const ordered_json record = ordered_json::parse(readBytes(sky.out("sky.json")));
  const auto requireUnreadable = [&](const ordered_json& forged) {
    INFO(forged["made"].dump());
    writeRecord(sky.out("sky.json"), forged);
    REQUIRE(sky.plan({})["sky"]["why"] == "unreadable: sky.json");
  };
  for (const char* key : {"table", "cubemaps", "gradients", "left_out", "outputs", "warnings", "certificate"}) {
    ordered_json forged = record;
    forged["made"].erase(key);
    requireUnreadable(forged);
    for (const char* value : {"{}", "[{}]", "1"}) {
      if (record["made"][key].is_object() && *value == '[') continue;
      forged["made"][key] = ordered_json::parse(value);
      requireUnreadable(forged);
    }
  }
  for (const char* name : {"/etc/passwd", "../sky.toml", "cubemaps/../sky.welkin", ""}) {
    ordered_json forged = record;
    forged["made"]["outputs"][0]["file"] = name;
    requireUnreadable(forged);
  }
  REQUIRE(sky.bake("out", {}));
  REQUIRE(ordered_json::parse(readBytes(sky.out("sky.json"))) == record);
}

TEST_CASE("SkyState, FilesOfAnotherBakeAreFound") {
  const BakedSky sky;
  const auto copy = [&](const std::string& name) {
    fs::copy_file(sky.folder() / ("other/" + name), sky.out(name), fs::copy_options::overwrite_existing);
  };
  REQUIRE(sky.bake("other", {"--max-error", "0.9", "--certify", "none"}));
  copy("sky.welkin");
  sky.requireBakes("changed: sky.welkin");
  copy("sky.json");
  sky.requireBakes("changed: max_error");
  sky.writeSky("intensity = 2");
  REQUIRE(sky.bake("other"));
  sky.writeSky("");
  copy(kCubemap);
  sky.requireBakes("changed: " + kCubemap);
  copy("sky.json");
  copy("sky.welkin");
  sky.requireBakes("changed: sky.toml");
  for (const auto& name : filesUnder(sky.folder() / "other/cubemaps")) copy("cubemaps/" + name);
  sky.requireBakes(
      "changed: cubemaps/sky_000000000.exr, cubemaps/sky_000000000_latlong.exr, "
      "cubemaps/sky_120000000.exr, " +
      kCubemap);
}

TEST_CASE("SkyState, WhatAKilledBakeLeftGoes") {
  const BakedSky sky;
  for (const char* name :
       {"sky.welkin.tmp", "sky.json.tmp", "cubemaps/sky_120000000.exr.tmp", "cubemaps/sky_030000000.exr"})
    sky.folder().write(std::string("out/") + name, "half");
  REQUIRE(sky.bake("whole"));
  REQUIRE_FALSE(sky.bake("out"));
  requireSameFolder(sky.folder() / "out", sky.folder() / "whole");
}

TEST_CASE("SkyState, ALevelKeepsItsSkyThroughEditsOfItsGeometry") {
  const SmallLevel level;
  level.bake("out");
  const auto sky_baked = [&](const std::string& out) {
    return json::parse(readBytes(level / (out + "/timing.json")))["sky_baked"].get<bool>();
  };
  level.writeHut(171.0);
  REQUIRE(level.bake("out") == 2);
  REQUIRE_FALSE(sky_baked("out"));
  level.bake("nothing");
  REQUIRE(sky_baked("nothing"));
  requireSameFolder(level / "out", level / "nothing");
  level.writeSky(60.0, "intensity = 2");
  REQUIRE(level.bake("out") == 0);
  REQUIRE(sky_baked("out"));
  REQUIRE(level.bake("out", {"--force"}) == kSectors);
  REQUIRE(sky_baked("out"));
}

TEST_CASE("SkyState, ALevelThatBeginsToReflectGetsCubemaps") {
  const Folder folder;
  folder.write("sky.toml", skyText(kUniform, kStillSun, "bands = 2\nkeys = 1"));
  const std::string level = folder.write(
      "level.toml", "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"a.gltf\"\n[transfer]\nrays = 64\n");
  const auto bake = [&](double roughness, const std::string& out) {
    GltfText model;
    const int material = model.addMaterial({0.5, 0.5, 0.5});
    model.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = roughness;
    model.addNode(model.addMesh(squareMesh(), material));
    folder.write("a.gltf", model.text());
    REQUIRE(runBake(level, folder / out, kUncertified).status == 0);
    return json::parse(readBytes(folder / (out + "/timing.json")))["sky_baked"].get<bool>();
  };
  REQUIRE(bake(0.9, "out"));
  REQUIRE_FALSE(bake(0.8, "out"));
  REQUIRE_FALSE(fs::exists(folder / "out/cubemaps"));
  REQUIRE(bake(0.1, "out"));
  REQUIRE(bake(0.1, "nothing"));
  requireSameFolder(folder / "out", folder / "nothing");
  REQUIRE_FALSE(bake(0.2, "out"));
  REQUIRE(bake(0.9, "out"));
  REQUIRE(filesUnder(folder / "out/cubemaps").empty());
}
