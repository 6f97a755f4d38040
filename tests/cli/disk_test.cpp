// SPDX-License-Identifier: Apache-2.0
// A disk, or a result pipe, that is full: status 2, nothing half-written, and what was there before stays.
#include <catch2/catch.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::test;
namespace fs = std::filesystem;

namespace {

std::string sky(double intensity) {
  return skyText(kUniform + "\nintensity = " + std::to_string(intensity), kStillSun,
                 "keys = 3\ncubemap_size = 8\ncubemap_times = 2");
}

Setting fullAfter(std::uintmax_t bytes) {
  return {{{"LD_PRELOAD", WELKIN_FULL_DISK}, {"WELKIN_DISK_BYTES", std::to_string(bytes)}}, "", "", 0, 60.0};
}

/// Three folders: out, with the sky that a failing bake is to replace; old, the same; fresh, what it would become.
void prepare(const Folder& folder) {
  const std::string file = folder.write("sky.toml", sky(1.0));
  REQUIRE(runTool({"bake", file, "-o", folder / "old"}).status == 0);
  folder.write("sky.toml", sky(2.0));
  REQUIRE(runTool({"bake", file, "-o", folder / "fresh"}).status == 0);
  fs::copy(folder / "old", folder / "out", fs::copy_options::recursive);
}

void requireOldOrNew(const Folder& folder) {
  REQUIRE(filesUnder(folder / "out") == filesUnder(folder / "old"));  // no *.tmp either
  for (const auto& name : filesUnder(folder / "out")) {
    if (name == "timing.json") continue;
    INFO(name);
    const std::string bytes = readBytes(folder.path() / "out" / name);
    const bool whole =
        bytes == readBytes(folder.path() / "old" / name) || bytes == readBytes(folder.path() / "fresh" / name);
    REQUIRE(whole);
  }
}

}  // namespace

TEST_CASE("FullDisk, BakeLeavesEveryFileOldOrNew") {
  const Folder folder;
  prepare(folder);
  const auto welkin = fs::file_size(folder / "fresh/sky.welkin");
  std::uintmax_t pictures = 0;
  for (const auto& name : filesUnder(folder / "fresh/cubemaps"))
    pictures += fs::file_size(folder.path() / "fresh/cubemaps" / name);
  for (const std::uintmax_t bytes : {std::uintmax_t{0}, pictures / 2, pictures + 1, pictures + welkin - 1}) {
    INFO(bytes << " bytes free");
    const Run run = runTool({"bake", folder / "sky.toml", "-o", folder / "out"}, fullAfter(bytes));
    INFO(run.err);
    REQUIRE(run.status == 2);
    REQUIRE(run.said("No space left on device"));
    REQUIRE(run.said(folder / "out/"));
    requireOldOrNew(folder);
    REQUIRE(readBytes(folder / "out/sky.welkin") == readBytes(folder / "old/sky.welkin"));
    fs::remove_all(folder / "out/cubemaps");
    fs::copy(folder / "old/cubemaps", folder / "out/cubemaps");
  }
  REQUIRE(runTool({"bake", folder / "sky.toml", "-o", folder / "out"}).status == 0);  // with room again
  REQUIRE(readBytes(folder / "out/sky.welkin") == readBytes(folder / "fresh/sky.welkin"));
}

TEST_CASE("FullDisk, InitLeavesNoHalfFile") {
  const Folder folder;
  const Run run = runTool({"init", folder / "level"}, fullAfter(100));
  REQUIRE(run.status == 2);
  REQUIRE(run.said("gradient_sun.png"));
  REQUIRE(filesUnder(folder / "level").empty());
}

TEST_CASE("FullDisk, FileSizeLimitIsAnErrorAndNotASignal") {
  const Folder folder;
  prepare(folder);
  Setting setting;
  setting.largest_file = 200;
  const Run run = runTool({"bake", folder / "sky.toml", "-o", folder / "out"}, setting);
  REQUIRE(run.status == 2);
  REQUIRE(run.said("File too large"));
  requireOldOrNew(folder);
}

TEST_CASE("FullDisk, ResultsThatCannotBeWrittenAreAnError") {
  const Folder folder;
  prepare(folder);
  const std::string out = folder / "out";
  Setting setting;
  setting.out_path = "/dev/full";
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"inspect", out, "--json"},
                                             {"inspect", out},
                                             {"sample", out, "--time", "1"},
                                             {"eval", folder / "sky.toml", "--time", "1", "--direction", "0,1,0"},
                                             {"plan", folder / "sky.toml"},
                                             {"validate", out},
                                             {"--help"},
                                             {"--version"}}) {
    const Run run = runTool(arguments, setting);
    INFO(arguments[0] << ": " << run.err);
    REQUIRE(run.status == 2);
    REQUIRE(run.said("stdout"));
  }
}

TEST_CASE("FullDisk, AFullStderrChangesNoStatus") {
  const Folder folder;
  const std::string file = folder.write("sky.toml", sky(1e9));  // brighter than half floats: a warning as well
  Setting setting;
  setting.err_path = "/dev/full";
  for (const char* progress : {"bar", "plain", "json", "none"})
    REQUIRE(runTool({"bake", file, "-o", folder / "out", "--progress", progress}, setting).status == 0);
  REQUIRE(runTool({"inspect", folder / "nothing"}, setting).status == 2);
  REQUIRE(runTool({"bake"}, setting).status == 1);
}
