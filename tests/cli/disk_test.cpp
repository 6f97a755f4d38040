// SPDX-License-Identifier: Apache-2.0
// A disk that fails at any call, and a full disk or result pipe: status 2, nothing half-written, and earlier files
// stay.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cerrno>
#include <cstring>
#include <sstream>
#include <string>

#include "sky_text.h"
#include "two_bakes.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

constexpr int kCubemapSize = 4;

std::string sky(double intensity) {
  return skyText(kUniform + "\nintensity = " + std::to_string(intensity), kStillSun,
                 "keys = 3\ncubemap_size = 8\ncubemap_times = 2");
}

Setting fullAfter(std::uintmax_t bytes) {
  return {{{"LD_PRELOAD", WELKIN_FAILING_DISK}, {"WELKIN_DISK_BYTES", std::to_string(bytes)}}, "", "", 0, 60.0};
}

/// Requires one line that names a file of the bake that the system refused, and the reason.
void requireRefusal(const Run& run, const TwoBakes& bakes, const std::string& why) {
  REQUIRE(run.status == 2);
  REQUIRE(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  REQUIRE(run.err.ends_with(": " + why + "\n"));
  const std::string place = bakes.out().parent_path().string();  // its names are flushed when `out` is made
  const bool names = run.err.starts_with("welkin: " + bakes.out().string()) ||
                     run.err.starts_with("welkin: " + place + ": cannot write") ||
                     run.err.starts_with("welkin: " + bakes.file("out.d") + ": cannot write");
  REQUIRE(names);
}

struct Call {
  std::string name, path, to;
};

std::vector<Call> callsOf(const std::string& log) {
  std::vector<Call> calls;
  std::istringstream lines(readBytes(log));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    words >> calls.emplace_back().name >> calls.back().path >> calls.back().to;
  }
  return calls;
}

}  // namespace

TEST_CASE("FailingDisk, AnyCallMayFailWithAnyError") {
  // Errors take turns. A file takes six calls and there are five errors, so each kind of call meets each of them.
  constexpr std::pair<const char*, int> kErrors[] = {
      {"ENOSPC", ENOSPC}, {"EIO", EIO}, {"EDQUOT", EDQUOT}, {"EROFS", EROFS}, {"EPERM", EPERM}};
  const bool into_new_folder = GENERATE(false, true);
  TwoBakes bakes(kCubemapSize);
  int call = 0;
  for (Run run{2, "", "", 0.0}; run.status != 0;) {
    into_new_folder ? bakes.putNothing() : bakes.putOld();
    const auto [fault, error] = kErrors[++call % 5];
    run = runTool(bakes.command("new"), on({fault, std::to_string(call), ""}));
    INFO(fault << " at call " << call << ": " << run.err);
    if (run.status != 0) requireRefusal(run, bakes, std::strerror(error));
    bakes.requireWhole();
  }
  bakes.requireIs("new");
  REQUIRE(call > 6 * 8);  // open, write, fsync, close, rename and the folder's fsync: four cubemaps, the sky, the
                          // report, times, the rule
}

TEST_CASE("FailingDisk, FromAnyCallOn") {
  // The system makes a device read-only after an error, so cleaning up is impossible as well.
  TwoBakes bakes(kCubemapSize);
  for (int call = 1;; ++call) {
    bakes.putOld();
    const Run run = runTool(bakes.command("new"), on({"EROFS", std::to_string(call) + "+", ""}));
    INFO("from call " << call << " on: " << run.err);
    if (run.status == 0) break;
    requireRefusal(run, bakes, std::strerror(EROFS));
    bakes.requireWhole(true);
    const std::string sky = call % 2 == 0 ? "old" : "new";  // also with the sky changed back
    REQUIRE(runTool(bakes.command(sky)).status == 0);
    bakes.requireIs(sky);
  }
}

TEST_CASE("FailingDisk, InterruptedCallsAndShortWritesAreNoErrors") {
  const auto [fault, call] =
      GENERATE(table<const char*, const char*>({{"EINTR", "1+"}, {"EINTR", "2+"}, {"short", "1+"}}));
  TwoBakes bakes(kCubemapSize);
  bakes.putOld();
  const Run run = runTool(bakes.command("new"), on({fault, call, ""}));
  INFO(fault << ": " << run.err);
  REQUIRE(run.status == 0);
  bakes.requireIs("new");
}

TEST_CASE("FailingDisk, FilesAreFlushedBeforeTheyGetTheirNameAndFoldersThen") {
  TwoBakes bakes(kCubemapSize);
  bakes.putOld();
  REQUIRE(runTool(bakes.command("new"), on({"", "", bakes.file("log")})).status == 0);
  std::vector<std::string> steps, named;
  for (const Call& call : callsOf(bakes.file("log"))) {
    INFO(call.name << " " << call.path << " " << call.to);
    if (call.name == "unlink" || call.path.ends_with(".welkin.lock")) continue;
    if (call.name == "open") steps.clear();
    steps.push_back(call.name);
    if (call.name == "rename") {
      REQUIRE(call.path == call.to + ".tmp");
      named.push_back(call.to);
    }
    if (steps.size() < 6) continue;
    REQUIRE(steps == std::vector<std::string>{"open", "write", "fsync", "close", "rename", "fsync"});
    REQUIRE(call.path == fs::path(named.back()).parent_path().string());
  }
  for (std::string& name : named) name = fs::path(name).filename();
  REQUIRE(named == std::vector<std::string>{"out.d", "sky_000000000.exr", "sky_000000000_latlong.exr",
                                            "sky_060000000.exr", "sky_060000000_latlong.exr", "sky.json", "sky.welkin",
                                            "timing.json", "report.json"});
}

TEST_CASE("FullDisk, BakeLeavesEveryFileOldOrNew") {
  TwoBakes bakes(kCubemapSize);
  bakes.putOld();
  REQUIRE(runTool(bakes.command("new")).status == 0);
  std::uintmax_t pictures = fs::file_size(bakes.file("out.d")) + fs::file_size(bakes.file("new/sky.json"));
  for (const auto& name : filesUnder(bakes.file("new/cubemaps")))
    pictures += fs::file_size(bakes.file("new/cubemaps/" + name));
  const auto welkin = fs::file_size(bakes.file("new/sky.welkin"));
  for (const std::uintmax_t bytes : {std::uintmax_t{0}, pictures / 2, pictures + 1, pictures + welkin - 1}) {
    INFO(bytes << " bytes free");
    bakes.putOld();
    const Run run = runTool(bakes.command("new"), fullAfter(bytes));
    INFO(run.err);
    requireRefusal(run, bakes, "No space left on device");
    bakes.requireWhole();
    REQUIRE(readBytes(bakes.out() / "sky.welkin") == readBytes(bakes.file("old/sky.welkin")));
  }
  REQUIRE(runTool(bakes.command("new")).status == 0);  // with space again
  bakes.requireIs("new");
}

TEST_CASE("FullDisk, InitLeavesNoHalfFile") {
  const Folder folder;
  const Run run = runTool({"init", folder / "level"}, fullAfter(100));
  REQUIRE(run.status == 2);
  REQUIRE(run.said("gradient_sun.png"));
  REQUIRE(filesUnder(folder / "level").empty());
}

TEST_CASE("FullDisk, FileSizeLimitIsAnErrorAndNotASignal") {
  TwoBakes bakes(kCubemapSize);
  bakes.putOld();
  Setting setting;
  setting.largest_file = 200;
  requireRefusal(runTool(bakes.command("new"), setting), bakes, "File too large");
  bakes.requireWhole();
}

TEST_CASE("FullDisk, ResultsThatCannotBeWrittenAreAnError") {
  const Folder folder;
  const std::string out = folder / "out";
  REQUIRE(runTool({"bake", folder.write("sky.toml", sky(1.0)), "-o", out}).status == 0);
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
  const std::string file =
      folder.write("sky.toml", sky(1e9));  // brighter than half floats, so there is a warning as well
  Setting setting;
  setting.err_path = "/dev/full";
  for (const char* progress : {"bar", "plain", "json", "none"})
    REQUIRE(runTool({"bake", file, "-o", folder / "out", "--progress", progress}, setting).status == 0);
  REQUIRE(runTool({"inspect", folder / "nothing"}, setting).status == 2);
  REQUIRE(runTool({"bake"}, setting).status == 1);
}
