// SPDX-License-Identifier: Apache-2.0
// Gradient images that are foreign, damaged or out of their domain: status 3, and the message names the image.
#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <string>

#include "run_tool.h"
#include "sky_text.h"
#include "tests/sky/png_bytes.h"

using namespace welkin::tests;

namespace {

/// The bytes of an image of floats, stored in the extension's format as `type`.
std::string imageBytes(const std::string& name, int width, int height, const std::vector<float>& rgb,
                       OIIO::TypeDesc type) {
  const Folder folder;
  auto output = OIIO::ImageOutput::create(name);
  REQUIRE(output);
  REQUIRE(output->open(folder / name, OIIO::ImageSpec(width, height, 3, type)));
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
  REQUIRE(output->close());
  return readBytes(folder / name);
}

std::string grey(const std::string& name, OIIO::TypeDesc type) {
  return imageBytes(name, 16, 16, std::vector<float>(16 * 16 * 3, 0.5F), type);
}

/// A PNG header that promises so many texels, without any.
std::string pngHeader(std::uint32_t width, std::uint32_t height) {
  const std::string fields = bigEndian(width) + bigEndian(height) + std::string("\x08\x02\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", fields) + chunk("IDAT", "");
}

void requireInvalid(const std::string& name, const std::string& bytes, const std::vector<std::string>& said,
                    const std::string& key = "gradient_sun") {
  const Folder folder;
  folder.write(name, bytes);
  const std::string sky = folder.write("sky.toml", skyText(kUniform + "\n" + key + " = \"" + name + "\""));
  const Run run = runTool({"bake", sky, "-o", folder / "out"}, {{}, "", "", 0, 60.0});
  INFO(name << ", " << bytes.size() << " bytes: " << run.err.substr(0, 600));
  REQUIRE(run.status == 3);
  REQUIRE(run.said("sky.toml:4: sky." + key + " = '" + name + "': " + (folder / name)));
  for (const auto& part : said) REQUIRE(run.said(part));
  REQUIRE_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace

TEST_CASE("ImageErrors, ForeignFiles") {
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.unknown"})
    requireInvalid(name, "some text\n", {"not an image"});
  for (const char* name : {"a.png", "a.exr"}) requireInvalid(name, "", {"not an image"});
  for (const char* key : {"gradient_anti", "polarising_tint"})
    requireInvalid("a.png", skyText(kUniform), {"not an image"}, key);
}

TEST_CASE("ImageErrors, CutFiles") {
  for (const auto& [name, type] : {std::pair<std::string, OIIO::TypeDesc>("a.png", OIIO::TypeDesc::UINT16),
                                   {"a.exr", OIIO::TypeDesc::HALF},
                                   {"a.tif", OIIO::TypeDesc::UINT8}}) {
    const std::string whole = grey(name, type);
    for (const std::size_t size : {std::size_t{4}, std::size_t{20}, whole.size() / 2, whole.size() * 3 / 4})
      requireInvalid(name, whole.substr(0, size), {});
  }
}

TEST_CASE("ImageErrors, ValuesOutOfTheirDomainAreLocated") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const auto& [value, text] : {std::pair(nan, "nan"), {infinity, "inf"}, {-infinity, "-inf"}, {-0.25F, "-0.25"}})
    for (const auto& [name, type] : {std::pair<std::string, OIIO::TypeDesc>("a.exr", OIIO::TypeDesc::HALF),
                                     {"a.exr", OIIO::TypeDesc::FLOAT},
                                     {"a.tif", OIIO::TypeDesc::FLOAT}}) {
      std::vector<float> rgb(8 * 4 * 3, 1.0F);
      rgb[3 * (2 * 8 + 5) + 1] = value;
      requireInvalid(name, imageBytes(name, 8, 4, rgb, type), {text, "column 5", "row 2", "channel 1"});
    }
}

TEST_CASE("ImageErrors, HugeHeadersTakeNoMemory") {
  requireInvalid("a.png", pngHeader(100000, 100000), {});
  requireInvalid("a.png", pngHeader(0x7fffffff, 0x7fffffff), {});
  requireInvalid("a.png", pngHeader(0, 0), {});
  requireInvalid("a.png", pngHeader(16385, 1), {"16385 x 1", "16384"});
  requireInvalid("a.png", pngHeader(16384, 16384), {"16777216"});
  requireInvalid("a.png", pngHeader(64, 64), {});
}
