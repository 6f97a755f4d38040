// SPDX-License-Identifier: Apache-2.0
// welkin render from the shell. tests/vulkan looks at the pictures.
#include <catch2/catch.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::test;
namespace fs = std::filesystem;

namespace {

const Setting kNoDevice = {
    {{"VK_ICD_FILENAMES", "/nonexistent"}, {"VK_DRIVER_FILES", "/nonexistent"}}, "", "", 0, 60.0};

std::string bakedFolder(const Folder& folder) {
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, "keys = 2\ncubemap_size = 4"));
  REQUIRE(runTool({"bake", sky, "-o", folder / "out"}).status == 0);
  return folder / "out";
}

}  // namespace

TEST_CASE("Render, WritesAPngOfTheSizeAskedFor") {
  if (!fs::exists(WELKIN_TEST_ICD)) {
    WARN("no " WELKIN_TEST_ICD);
    return;
  }
  const Folder folder;
  const Setting lavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 120.0};
  const Run run = runTool({"render", bakedFolder(folder), "--time", "-12", "--exposure", "-2", "--yaw", "-20",
                           "--pitch", "-5", "--view", "horizon", "--size", "48x32", "-o", folder / "a.png"},
                          lavapipe);
  INFO(run.err);
  REQUIRE(run.status == 0);
  const std::string png = readBytes(folder / "a.png");
  REQUIRE(png.size() > 33);
  REQUIRE(png.substr(1, 3) == "PNG");
  REQUIRE(png.substr(16, 8) == std::string("\0\0\0\x30\0\0\0\x20", 8));  // IHDR: width and height
}

TEST_CASE("Render, WithoutADeviceIsARefusalOfTheSystem") {
  const Folder folder;
  const Run run = runTool({"render", bakedFolder(folder), "--time", "12", "-o", folder / "a.png"}, kNoDevice);
  INFO(run.err);
  REQUIRE(run.status == 2);
  REQUIRE(run.said("Vulkan"));
  REQUIRE_FALSE(fs::exists(folder / "a.png"));
}
