// SPDX-License-Identifier: Apache-2.0
// welkin export: names, sizes and bytes of its files, and its refusals. What is in the files is tested in tests/maps.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "baked.h"

using namespace welkin::tests;

namespace {

/// A baked day in FOLDER/out, with cubemaps of so many texels or none.
std::string bakedDay(const Folder& folder, int cubemap_size) {
  const std::string sky = folder.write(
      "sky.toml",
      skyText(kDay, kDaySun, "keys = 4\ncubemap_times = 1\ncubemap_size = " + std::to_string(cubemap_size)));
  const Run run = runBake(sky, folder / "out", {"--certify", "none"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  return folder / "out";
}

Run runExport(const std::string& path, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"export", path};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runTool(arguments);
}

}  // namespace

TEST_CASE("Export, NamesCarryTimeAndEngine") {
  const Folder folder;
  const std::string out = bakedDay(folder, 0);
  const struct {
    std::vector<std::string> options, files;
  } cases[] = {
      {{"--to", "ktx2"}, {"sky_063000000.ktx2", "sky_063000000_sh.json"}},
      {{"--to", "ktx2", "--target", "three", "--format", "rgb9e5"},
       {"sky_063000000_sh.json", "sky_063000000_three.ktx2"}},
      {{"--to", "dds", "--target", "unreal", "--format", "bc6h", "--mips"},
       {"sky_063000000_sh.json", "sky_063000000_unreal.dds"}},
      {{"--to", "faces", "--target", "unity"},
       {"sky_063000000_sh.json", "sky_063000000_unity_nx.exr", "sky_063000000_unity_ny.exr",
        "sky_063000000_unity_nz.exr", "sky_063000000_unity_px.exr", "sky_063000000_unity_py.exr",
        "sky_063000000_unity_pz.exr"}},
      {{"--to", "hdr", "--target", "godot"}, {"sky_063000000_godot_latlong.hdr", "sky_063000000_sh.json"}},
      {{"--to", "hdr", "--format", "exr"}, {"sky_063000000_latlong.exr", "sky_063000000_sh.json"}},
      {{"--to", "dds", "--target", "three", "--prefilter"},
       {"sky_063000000_sh.json", "sky_063000000_three_prefiltered.dds", "sky_063000000_three_prefiltered.json"}},
      {{"--to", "hdr", "--prefilter", "--size", "2"},
       {"sky_063000000_prefiltered.json", "sky_063000000_prefiltered_mip0_latlong.hdr",
        "sky_063000000_prefiltered_mip1_latlong.hdr", "sky_063000000_sh.json"}}};
  for (const auto& one : cases) {
    const Folder into;
    std::vector<std::string> options = {"--time", "6.5", "-o", into / "maps"};
    if (std::find(one.options.begin(), one.options.end(), "--size") == one.options.end())
      options.insert(options.end(), {"--size", "8"});
    options.insert(options.end(), one.options.begin(), one.options.end());
    const Run run = runExport(out, options);
    INFO(run.err);
    REQUIRE(run.status == 0);
    CHECK(run.err.empty());
    CHECK(filesUnder(into / "maps") == one.files);
    for (const std::string& name : one.files) CHECK(run.out.find(name) != std::string::npos);
  }
}

TEST_CASE("Export, SizeIsTheCubemapsUnlessItIsGiven") {
  const Folder folder;
  const std::string out = bakedDay(folder, 16);
  REQUIRE(runExport(out, {"--to", "dds", "--time", "12"}).status == 0);
  CHECK(readBytes(out + "/export/sky_120000000.dds").size() == 148 + 6 * 16 * 16 * 8);
  REQUIRE(runExport(out + "/sky.welkin", {"--to", "dds", "--time", "12", "--size", "5"}).status == 0);
  CHECK(readBytes(out + "/export/sky_120000000.dds").size() == 148 + 6 * 5 * 5 * 8);
}

TEST_CASE("Export, WithoutCubemapsItSaysTheSize") {
  const Folder folder;
  const std::string out = bakedDay(folder, 0);
  const Run run = runExport(out, {"--to", "dds", "--format", "rgb9e5", "--time", "12"});
  REQUIRE(run.status == 0);
  CHECK(run.said("no cubemaps"));
  CHECK(readBytes(out + "/export/sky_120000000.dds").size() == 148 + 6 * 256 * 256 * 4);
}

TEST_CASE("Export, SameBytesForAnyNumberOfThreads") {
  const Folder folder;
  const std::string out = bakedDay(folder, 0);
  for (const char* to : {"ktx2", "hdr"}) {
    const std::vector<std::string> options = {"--to", to,       "--target", "three",  "--time",
                                              "6",    "--time", "-5.25",    "--size", "12"};
    for (const char* threads : {"1", "2", "8"}) {
      std::vector<std::string> more = options;
      more.insert(more.end(), {"--threads", threads, "-o", folder / threads});
      REQUIRE(runExport(out, more).status == 0);
    }
    const auto files = filesUnder(folder / "1");
    CHECK(files.size() >= 4);  // two times, 6:00 and 18:45, with their coefficients
    for (const std::string& name : files)
      for (const char* threads : {"2", "8"})
        CHECK(readBytes(folder / "1" + "/" + name) == readBytes(folder / threads + "/" + name));
  }
}

TEST_CASE("Export, PrefilteredChainsAreTheSameForAnyNumberOfThreads") {
  const Folder folder;
  const std::string out = bakedDay(folder, 0);
  for (const char* threads : {"1", "3"}) {
    const Run run = runExport(out, {"--to", "ktx2", "--prefilter", "--time", "6", "--size", "8", "--threads", threads,
                                    "-o", folder / threads});
    REQUIRE(run.status == 0);
    CHECK(run.out.find("bytes, error ") != std::string::npos);
  }
  const auto files = filesUnder(folder / "1");
  CHECK(files.size() == 3);
  for (const std::string& name : files)
    CHECK(readBytes(folder / "1" + "/" + name) == readBytes(folder / "3" + "/" + name));
}

TEST_CASE("Export, RefusesWhatItCannotWrite") {
  const Folder folder;
  const std::string out = bakedDay(folder, 0);
  const struct {
    std::vector<std::string> options;
    std::string said;
  } usage[] = {{{"--time", "1"}, "--to"},
               {{"--to", "ktx2"}, "--time"},
               {{"--to", "png", "--time", "1"}, "png"},
               {{"--to", "ktx2", "--time", "noon"}, "noon"},
               {{"--to", "ktx2", "--time", "nan"}, "nan"},
               {{"--to", "ktx2", "--time", "1", "--time", "25"}, "same millisecond"},
               {{"--to", "ktx2", "--time", "1", "--target", "cryengine"}, "three, unity, unreal, godot, filament"},
               {{"--to", "ktx2", "--time", "1", "--format", "exr"}, "rgba16f, rgb9e5 or bc6h"},
               {{"--to", "faces", "--time", "1", "--format", "bc6h"}, "exr or hdr"},
               {{"--to", "hdr", "--time", "1", "--mips"}, "--mips"},
               {{"--to", "dds", "--time", "1", "--format", "bc6h", "--size", "6"}, "multiples of 4"},
               {{"--to", "dds", "--time", "1", "--mips", "--prefilter"}, "--prefilter"},
               {{"--to", "dds", "--time", "1", "--prefilter", "--size", "1"}, "2 to 512"},
               {{"--to", "faces", "--time", "1", "--prefilter", "--size", "513"}, "2 to 512"},
               {{"--to", "dds", "--time", "1", "--size", "0"}, "--size"},
               {{"--to", "dds", "--time", "1", "--size", "4097"}, "--size"}};
  for (const auto& one : usage) {
    std::vector<std::string> options = one.options;
    options.insert(options.end(), {"-o", folder / "maps"});
    const Run run = runExport(out, options);
    INFO(one.said << "\n" << run.err);
    CHECK(run.status == 1);
    CHECK(run.said(one.said));
    CHECK_FALSE(std::filesystem::exists(folder / "maps"));
  }
  const std::vector<std::string> right = {"--to", "ktx2", "--time", "1", "-o", folder / "maps"};
  CHECK(runExport(folder / "none", right).status == 2);
  CHECK(runExport(folder.path().string(), right).said("sky.welkin"));
  const Run foreign = runExport(folder.write("foreign.welkin", "no sky at all"), right);
  CHECK(foreign.status == 3);
  CHECK(foreign.said("foreign.welkin"));
  CHECK_FALSE(std::filesystem::exists(folder / "maps"));
}
