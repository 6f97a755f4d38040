// SPDX-License-Identifier: Apache-2.0
// Interrupts a bake.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

constexpr double kSoon_s = 10.0;  // Long before the bake would end by itself, even on a machine busy with other tests.

bool anyTemporary(const fs::path& folder) {
  for (const auto& name : filesUnder(folder))
    if (name.ends_with(".tmp")) return true;
  return false;
}

std::string bakeSection(int size, const std::string& times) {
  return "keys = 2\ncubemap_size = " + std::to_string(size) + "\ncubemap_times = " + times;
}

}  // namespace

TEST_CASE("Interrupt, EndsInTheMiddleOfALargeCubemap") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText("", kStillSun, bakeSection(2048, "7")));
  Tool tool({"bake", sky, "-o", folder / "out", "--progress", "none", "--certify", "none"});
  while (!fs::exists(folder / "out/cubemaps")) REQUIRE_FALSE(tool.endsWithin(0.01));
  REQUIRE_FALSE(tool.endsWithin(1.0));  // one cubemap of this size takes many seconds
  tool.send(signal);
  REQUIRE(tool.endsWithin(kSoon_s));
  const Run run = tool.wait();
  REQUIRE(run.status == 130);
  REQUIRE(run.said("interrupted"));
  REQUIRE_FALSE(fs::exists(folder / "out/sky.welkin"));
  REQUIRE_FALSE(anyTemporary(folder / "out"));
}

TEST_CASE("Interrupt, KeepsWholeFilesAndTheOldSky") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, bakeSection(256, "[0, 3]")));
  REQUIRE(runTool({"bake", sky, "-o", folder / "out", "--progress", "none", "--certify", "none"}).status == 0);
  REQUIRE(runTool({"bake", sky, "-o", folder / "same", "--progress", "none", "--certify", "none"}).status == 0);
  folder.write("sky.toml", skyText(kUniform, kStillSun, bakeSection(256, "200")));
  Tool tool({"bake", sky, "-o", folder / "out", "--progress", "none", "--certify", "none"});
  while (!fs::exists(folder / "out/cubemaps/sky_001424000.exr")) REQUIRE_FALSE(tool.endsWithin(0.01));
  tool.send(SIGINT);
  REQUIRE(tool.endsWithin(kSoon_s));
  REQUIRE(tool.wait().status == 130);
  REQUIRE_FALSE(anyTemporary(folder / "out"));
  for (const auto& name : filesUnder(folder / "same"))
    if (name != "timing.json")
      REQUIRE(readBytes(folder.path() / "out" / name) == readBytes(folder.path() / "same" / name));
  // A uniform sky looks the same at any hour, so every finished picture is that one, whole.
  REQUIRE(readBytes(folder / "out/cubemaps/sky_000712000.exr") ==
          readBytes(folder / "same/cubemaps/sky_000000000.exr"));
  REQUIRE(runTool({"validate", folder / "out"}).status == 0);
}

TEST_CASE("Interrupt, EndsInThePlanAndInTheCertificate") {
  const auto& [work, budget] = GENERATE(std::pair<std::string, std::string>{"plan", "0.003"},
                                        std::pair<std::string, std::string>{"certificate", "0.5"});
  const Folder folder;
  const std::string sky = folder.write(
      "sky.toml", skyText("", "latitude_deg = 40\nday_of_year = 100", "cubemap_size = 0\nmax_error = " + budget));
  Setting setting;
  setting.err_path = folder / "err";
  Tool tool({"bake", sky, "-o", folder / "out", "--progress", "bar", "--certify", "full"}, setting);
  while (readBytes(folder / "err").find(work) == std::string::npos) REQUIRE_FALSE(tool.endsWithin(0.01));
  tool.send(SIGINT);
  REQUIRE(tool.endsWithin(kSoon_s));
  REQUIRE(tool.wait().status == 130);
  REQUIRE(readBytes(folder / "err").find("interrupted") != std::string::npos);
  REQUIRE(filesUnder(folder / "out").empty());
}

// A level of many triangles: most of its bake is reading, ordering, hashing and placing.
TEST_CASE("Interrupt, EveryStageOfALevelHearsItWithinASecond") {
  constexpr int kSide = 300;
  constexpr double kInTime_s = 1.0;
  const Folder folder;
  std::string obj;
  for (int z = 0; z <= kSide; ++z)
    for (int x = 0; x <= kSide; ++x)
      obj += "v " + std::to_string(x) + " " + std::to_string(x * z % 7) + " " + std::to_string(z) + "\n";
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      const int a = z * (kSide + 1) + x + 1;
      const int b = a + kSide + 1;
      for (const auto& [second, third] : {std::pair(b, b + 1), std::pair(b + 1, a + 1)})
        obj += "f " + std::to_string(a) + " " + std::to_string(second) + " " + std::to_string(third) + "\n";
    }
  folder.write("sky.toml", skyText(kUniform));
  folder.write("a.obj", obj);
  const std::string level = folder.write(
      "level.toml", "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"a.obj\"\n[transfer]\nrays = 256\n");
  constexpr int kSignals = 8;
  constexpr double kLonger_s = 3.0;
  for (int i = 0; i < kSignals; ++i) {
    Tool tool({"bake", level, "-o", folder / "out", "--progress", "none", "--certify", "none"});
    const double delay_s = 0.1 + kLonger_s * i / kSignals;
    if (tool.endsWithin(delay_s)) break;
    tool.send(i % 2 == 0 ? SIGINT : SIGTERM);
    INFO("after " << delay_s << " s");
    REQUIRE(tool.endsWithin(kInTime_s));
    const int status = tool.wait().status;
    REQUIRE((status == 130 || status == 0 || (i == 0 && status == -SIGINT)));  // the first comes as libraries load
    fs::remove_all(folder / "out/sectors");
  }
}
