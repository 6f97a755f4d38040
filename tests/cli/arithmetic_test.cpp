// SPDX-License-Identifier: Apache-2.0
// A library changes the floating-point environment of the program. A bake then writes nothing or the same bytes.
#include <catch2/catch.hpp>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

Setting with(const std::string& mxcsr, bool late) {
  Setting setting;
  setting.environment = {{"LD_PRELOAD", WELKIN_FLUSH_TO_ZERO}, {"WELKIN_MXCSR", mxcsr}};
  if (late) setting.environment.emplace_back("WELKIN_MXCSR_LATE", "1");
  return setting;
}

}  // namespace

TEST_CASE("Arithmetic, ChangedByALoadedLibraryIsRefused") {
  // Flush to zero, denormals are zero, both; rounding down, up, to zero.
  const std::string mxcsr = GENERATE("8000", "0040", "8040", "2000", "4000", "6000");
  const std::string said =
      mxcsr < "2000" || mxcsr > "6000" ? "takes denormal numbers for zero" : "does not round to nearest";
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  const Run run = runTool({"bake", sky, "-o", folder / "out"}, with(mxcsr, false));
  INFO(mxcsr << ": " << run.err);
  REQUIRE(run.status == 4);
  REQUIRE(run.said(said));
  REQUIRE_FALSE(fs::exists(folder / "out"));
  REQUIRE(runTool({"bake", sky, "-o", folder / "out"}, with("0", false)).status == 0);
}

TEST_CASE("Arithmetic, ChangedByWhatReadsImagesIsMended") {
  const Folder folder;
  REQUIRE(runTool({"init", folder / "level"}).status == 0);
  const std::string sky = folder.write("level/small.toml", skyText("gradient_sun = \"gradient_sun.png\"", kStillSun,
                                                                   "keys = 3\ncubemap_size = 8\ncubemap_times = 2"));
  REQUIRE(runTool({"bake", sky, "-o", folder / "want"}).status == 0);
  REQUIRE(runTool({"bake", sky, "-o", folder / "got"}, with("e040", true)).status == 0);
  const bool same = readBytes(folder / "got/sky.welkin") == readBytes(folder / "want/sky.welkin");
  REQUIRE(same);
}
