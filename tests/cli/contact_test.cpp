// SPDX-License-Identifier: Apache-2.0
// welkin contact: factors of vertices beside the path tracer's light and the probes'.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "run_tool.h"
#include "sky_text.h"
#include "tests/gltf_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

/// A floor of 24 x 24 m in squares of 1 m. A slab of 6 x 4 m hangs 0.7 m over it, not in the middle.
class Slab {
 public:
  Slab() {
    GltfText model;
    MeshText floor;
    constexpr int kSide = 24;
    for (int z = 0; z <= kSide; ++z)
      for (int x = 0; x <= kSide; ++x) {
        floor.positions.insert(floor.positions.end(), {float(x), 0.0F, float(z)});
        floor.normals.insert(floor.normals.end(), {0.0F, 1.0F, 0.0F});
      }
    for (int z = 0; z < kSide; ++z)
      for (int x = 0; x < kSide; ++x) {
        const auto at = [&](int i, int k) { return static_cast<uint16_t>(x + i + (z + k) * (kSide + 1)); };
        floor.indices.insert(floor.indices.end(), {at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0)});
      }
    model.addNode(model.addMesh(floor), {{"translation", {20, 0, 20}}, {"name", "floor"}});
    model.addNode(model.addMesh(boxMesh()), {{"translation", {28, 0.8, 30}}, {"scale", {3, 0.1, 2}}, {"name", "slab"}});
    folder_.write("level.gltf", model.text());
    folder_.write("sky.toml", skyText(kUniform, "path = [[0, 0, -30], [6, 90, 0], [12, 180, 60], [18, 270, 0]]"));
    writeLevel(256);
  }
  void writeLevel(int rays) const {
    folder_.write("level.toml",
                  "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"level.gltf\"\nalbedo = [0.5, 0.5, 0.5]\n"
                  "[probes]\nspacing_m = 8\n[transfer]\nrays = " +
                      std::to_string(rays) + "\n");
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  std::filesystem::path path() const { return folder_.path(); }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }

  void bake() const {
    const Run run =
        runTool({"bake", *this / "level.toml", "-o", *this / "out", "--progress", "none", "--certify", "none"});
    INFO(run.err);
    REQUIRE(run.status == 0);
  }
  Run contact(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"contact", *this / "out", "--progress", "none"};
    words.insert(words.end(), more.begin(), more.end());
    return runTool(words);
  }

 private:
  Folder folder_;
};

struct Record {
  float position[3];
  signed char normal[3];
  unsigned char factor;
};

std::vector<Record> recordsOf(const Slab& level) {
  const std::string bytes = readBytes(level / "out/contact.bin");
  std::vector<Record> records(bytes.size() / sizeof(Record));
  std::memcpy(records.data(), bytes.data(), records.size() * sizeof(Record));
  return records;
}

double factorOf(const Record& r) {
  return r.factor / 170.0;
}

/// Green irradiance at points by `sample` or `reference`.
std::vector<double> lightAt(const Slab& level, const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  words.insert(words.end(), {"--time", "12", "--points", level / "points.csv", "--json"});
  const Run run = runTool(words);
  INFO(run.err);
  REQUIRE(run.status == 0);
  std::vector<double> light;
  const json points = json::parse(run.out)["points"];
  for (const json& p : points) light.push_back(p["irradiance"][1]);
  return light;
}

}  // namespace

TEST_CASE("Contact, FactorsBringTheProbesToTheTracedLight") {
  const Slab level;
  level.bake();
  const Run run = level.contact();
  INFO(run.err);
  REQUIRE(run.status == 0);
  const json index = json::parse(readBytes(level / "out/contact.json"));
  CHECK(index["pieces"][0]["object"] == "floor");
  CHECK(index["pieces"][0]["count"] == 625);
  CHECK(index["pieces"][1]["object"] == "slab");
  CHECK(index["error"]["contact"].get<double>() < 0.6 * index["error"]["probes"].get<double>());
  const json shown = json::parse(runTool({"inspect", level / "out/level.welkin", "--json"}).out)["level"]["contact"];
  CHECK(shown == json({{"vertices", index["vertices"]}, {"error", index["error"]}}));
  const std::vector<Record> records = recordsOf(level);
  REQUIRE(records.size() == index["vertices"].get<std::size_t>());
  std::string points;
  std::vector<double> factor;
  for (int i = 0; i < 625; ++i) {
    const Record& r = records[static_cast<std::size_t>(i)];
    const int x = i % 25, z = i / 25;
    REQUIRE(r.position[0] == 20.0F + float(x));
    REQUIRE(r.position[2] == 20.0F + float(z));
    REQUIRE(r.normal[1] == 127);
    // A row across the slab, which covers x 25 to 31 at z 30, and one beside it.
    if ((z != 10 && z != 17) || x == 0 || x == 24) continue;
    points += std::to_string(r.position[0]) + ",0.001," + std::to_string(r.position[2]) + ",0,1,0\n";
    factor.push_back(factorOf(r));
  }
  level.write("points.csv", points);
  const std::vector<double> probes = lightAt(level, {"sample", level / "out"});
  const std::vector<double> truth = lightAt(level, {"reference", level / "level.toml", "--samples", "4096"});
  REQUIRE(probes.size() == factor.size());
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < factor.size(); ++i) {
    before += std::pow(probes[i] - truth[i], 2);
    after += std::pow(factor[i] * probes[i] - truth[i], 2);
  }
  // Under the middle of the slab 0.7 m of gap leave a twentieth of the sky; in the open there is nothing to correct.
  CHECK(after < 0.1 * before);
  CHECK(factor[7] < 0.35);                  // x 28, z 30
  CHECK(factor[7] < factor[3]);             // x 24
  CHECK(std::abs(factor[22] - 1.0) < 0.1);  // x 43, z 30
}

TEST_CASE("Contact, TheSameBytesForAnyNumberOfThreads") {
  const Slab level;
  level.bake();
  REQUIRE(level.contact({"--threads", "1"}).status == 0);
  const std::string bin = readBytes(level / "out/contact.bin"), text = readBytes(level / "out/contact.json");
  REQUIRE(level.contact({"--threads", "3"}).status == 0);
  CHECK(readBytes(level / "out/contact.bin") == bin);
  CHECK(readBytes(level / "out/contact.json") == text);
}

TEST_CASE("Contact, RefusalsNameTheFile") {
  const Slab level;
  const Run none = level.contact();
  CHECK(none.status == 2);
  CHECK(none.said("holds no level.welkin"));
  level.bake();
  REQUIRE(level.contact().status == 0);
  const auto render = [&](int status, const std::string& says) {
    const Run run = runTool({"render", level / "out", "--time", "12", "--size", "48x32", "--camera", "30,3,45",
                             "--occlusion", "contact", "-o", level / "a.png"},
                            {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 120.0});
    INFO(run.err);
    CHECK(run.status == status);
    CHECK(run.said(says));
  };
  const std::string bin = readBytes(level / "out/contact.bin"), text = readBytes(level / "out/contact.json");
  const auto damaged = [](std::string of, std::size_t at) {
    of[at] = static_cast<char>(of[at] ^ 4);
    return of;
  };
  level.write("out/contact.bin", damaged(bin, 1001));
  render(3, "contact.bin: is damaged");
  level.write("out/contact.bin", bin.substr(0, 100));
  render(3, "contact.bin: is damaged");
  level.write("out/contact.bin", bin);
  level.write("out/contact.json", "{\"welkin_contact\": 1");
  render(3, "contact.json: is no list");
  level.write("out/contact.json", damaged(text, text.find("contact\": 1") + 10));
  render(3, "welkin_contact is 5, must be 1");
  level.write("out/contact.json", text);
  level.writeLevel(128);
  const Run changed = level.contact();
  CHECK(changed.status == 3);
  CHECK(changed.said("bake it anew"));
  const auto inspected = [&] { return runTool({"inspect", level / "out"}).out; };
  CHECK(inspected().find("contact factors of") != std::string::npos);
  level.bake();
  render(3, "is of another bake of the level");
  CHECK(inspected().find("no contact factors: ") != std::string::npos);
  std::filesystem::remove(level.path() / "out/contact.json");
  std::filesystem::remove(level.path() / "out/contact.bin");
  render(2, "welkin contact");
}

TEST_CASE("Contact, APictureTakesTheFactors") {
  const Slab level;
  level.bake();
  REQUIRE(level.contact().status == 0);
  const auto error = [&](const std::string& occlusion) {
    const Run run =
        runTool({"render",       level / "out", "--time",  "12",           "--size",     "64x48",       "--camera",
                 "24,5,40",      "--yaw",       "10",      "--pitch",      "-25",        "--component", "ambient",
                 "--difference", "--json",      "--paths", "128",          "--validate", "--occlusion", occlusion,
                 "--progress",   "none",        "-o",      level / "a.png"},
                {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 120.0});
    INFO(run.err);
    REQUIRE(run.status == 0);
    return json::parse(run.out)["pictures"][0]["error"]["probes"]["rms"].get<double>();
  };
  const double without = error("none");
  INFO(without);
  CHECK(error("contact") < 0.6 * without);
}

TEST_CASE("Contact, TheViewerTakesTheFactorsOfItsBakeAlone") {
  const Slab level;
  level.bake();
  REQUIRE(level.contact().status == 0);
  const auto viewed = [&](const std::string& script) {
    level.write("look.txt", script + "state " + level / "state.json\n");
    const Run run =
        runTool({"view", level / "out", "--headless", "--validate", "--size", "64x48", "--script", level / "look.txt"},
                {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 120.0});
    INFO(run.err);
    REQUIRE(run.status == 0);
    return json::parse(readBytes(level / "state.json"));
  };
  const std::string look =
      "time 12\nset direct off\ncamera 24 5 40 10 -25\npaths 128\ncompare baked reference difference\n";
  const json with = viewed(look), without = viewed(look + "set contact off\n");
  CHECK(with["contact_factors"] > 0);
  CHECK(with["changes"]["contact"] == true);
  CHECK(with["warnings"].empty());
  CHECK(double{with["compare"]["error"]["rms"]} < 0.6 * double{without["compare"]["error"]["rms"]});
  level.writeLevel(128);
  level.bake();
  const json stale = viewed(look);
  CHECK(stale["contact_factors"] == 0);
  REQUIRE(stale["warnings"].size() == 1);
  CHECK(stale["warnings"][0]["id"] == "contact");
  CHECK(std::string(stale["warnings"][0]["message"]).find("of another bake") != std::string::npos);
}
