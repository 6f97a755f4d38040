// SPDX-License-Identifier: Apache-2.0
// welkin project: its numbers for a baked cubemap, and its messages on bad input.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

json projected(const std::string& image, const std::string& bands) {
  const Run run = runTool({"project", image, "--bands", bands, "--json"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  REQUIRE(run.err.empty());
  return json::parse(run.out);
}

}  // namespace

TEST_CASE("Project, TheBakedCubemapsHoldTheTablesSky") {
  const Folder folder;
  const std::string sky = skyText(
      "luminance = \"cie-12\"\ngradient_sun = [1, 0.6, 0.3]\ngradient_anti = [0.3, 0.5, 1]\n"
      "ground_albedo = [0.2, 0.3, 0.1]",
      "path = [[12, 130, 35]]\nilluminance = 2", "bands = 3\nkeys = [12]\ncubemap_size = 64\ncubemap_times = [12]");
  REQUIRE(runTool({"bake", folder.write("sky.toml", sky), "-o", folder / "out"}).status == 0);
  const auto table = json::parse(runTool({"inspect", folder / "out", "--json"}).out)["sky"]["keys"][0]["radiance_sh"];
  for (const auto& [name, layout] :
       {std::pair("sky_120000000.exr", "cube"), {"sky_120000000_latlong.exr", "latlong"}}) {
    const auto image = projected(folder / ("out/cubemaps/" + std::string(name)), "3");
    REQUIRE(image["layout"] == layout);
    REQUIRE(image["rule"] == "openexr");
    REQUIRE(image["warnings"].empty());
    for (const char* channel : {"r", "g", "b"})
      for (std::size_t k = 0; k < 9; ++k) {
        CAPTURE(name, channel, k);
        const double c0 = table[channel][0];
        // 64 texels a face cut the horizon and the sun's cusp: 5e-3 of c0 measured.
        REQUIRE(double{image["radiance_sh"][channel][k]} == Approx(double{table[channel][k]}).margin(1e-2 * c0));
      }
  }
}

TEST_CASE("Project, PrintsATableForPeople") {
  const Folder folder;
  const std::string image = folder.write("a.ppm", "P3\n2 1\n255\n255 0 0 255 0 0\n");
  const Run run = runTool({"project", image, "--bands", "2"});
  REQUIRE(run.status == 0);
  REQUIRE(run.out.find("latlong of 2 x 1, half-texel rule") != std::string::npos);
  REQUIRE(run.out.find("3.544907701811") != std::string::npos);  // 2 sqrt(pi)
}

TEST_CASE("Project, BadInputNamesFileAndWhatIsAllowed") {
  const Folder folder;
  const Run missing = runTool({"project", folder / "none.exr", "--bands", "3"});
  REQUIRE(missing.status == 2);
  REQUIRE(missing.said("none.exr"));
  const Run foreign = runTool({"project", folder.write("a.exr", "hello"), "--bands", "3"});
  REQUIRE(foreign.status == 3);
  REQUIRE(foreign.said("a.exr: not an image that can be read"));
  const Run square = runTool({"project", folder.write("a.ppm", "P3\n2 2\n255\n1 1 1 1 1 1 1 1 1 1 1 1\n")});
  REQUIRE(square.status == 3);
  REQUIRE(square.said("2 x 2 texels"));
  for (const char* bands : {"0", "11", "-1", "x", "nan"})
    REQUIRE(runTool({"project", folder / "a.ppm", "--bands", bands}).status == 1);
}
