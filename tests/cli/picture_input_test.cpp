// SPDX-License-Identifier: Apache-2.0
// Pictures of project and of gradients: what a header says is printed and counted, numbers that cannot be are refused
// in one line, and neither a cut nor a damaged file shows memory that nothing wrote.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "run_tool.h"
#include "sky_text.h"
#include "tests/sky/png_bytes.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

/// A Radiance picture of 2 x 1 with the mantissas 127 at exponent 129: about 1.
std::string radiance(const std::string& fields) {
  return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + fields + "\n-Y 1 +X 2\n\x7f\x7f\x7f\x81\x7f\x7f\x7f\x81";
}

bool isOneLine(const Run& run) {
  return run.err.starts_with("welkin: ") && std::count(run.err.begin(), run.err.end(), '\n') == 1;
}

/// Both project and a gradient refuse the picture with one line that names it.
void requireRefused(const std::string& name, const std::string& bytes, const std::string& why) {
  const Folder folder;
  const std::string picture = folder.write(name, bytes);
  const std::string sky = folder.write("sky.toml", skyText(kUniform + "\ngradient_sun = \"" + name + "\""));
  for (const Run& run : {runTool({"project", picture}), runTool({"plan", sky})}) {
    INFO(name << ": " << run.err);
    REQUIRE(run.status == 3);
    REQUIRE(isOneLine(run));
    REQUIRE(run.said(picture + ": "));
    REQUIRE(run.said(why));
  }
}

/// Noise, so that no codec makes a picture's end redundant.
std::string written(const std::string& name, OIIO::TypeDesc type, const std::string& compression = "") {
  constexpr int kWidth = 64, kHeight = 32;
  std::vector<float> rgb;
  std::uint32_t state = 1;
  for (int i = 0; i < 3 * kWidth * kHeight; ++i) {
    state = state * 1664525U + 1013904223U;
    rgb.push_back(static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U));
  }
  const Folder folder;
  const auto output = OIIO::ImageOutput::create(name);
  REQUIRE(output);
  OIIO::ImageSpec spec(kWidth, kHeight, 3, type);
  if (!compression.empty()) spec.attribute("compression", compression);
  spec.attribute("tiff:RowsPerStrip", 8);
  REQUIRE(output->open(folder / name, spec));
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
  REQUIRE(output->close());
  return readBytes(folder / name);
}

std::vector<std::pair<std::string, std::string>> formats() {
  using OIIO::TypeDesc;
  return {{"none.tif", written("a.tif", TypeDesc::UINT8, "none")},
          {"lzw.tif", written("a.tif", TypeDesc::UINT8, "lzw")},
          {"zip.tif", written("a.tif", TypeDesc::FLOAT, "zip")},
          {"a.jpg", written("a.jpg", TypeDesc::UINT8)},
          {"a.png", written("a.png", TypeDesc::UINT16)},
          {"a.exr", written("a.exr", TypeDesc::HALF, "zip")},
          {"a.hdr", written("a.hdr", TypeDesc::FLOAT)},
          {"a.ppm", written("a.ppm", TypeDesc::UINT8)}};
}

/// The same command over memory that holds other bytes before it is written.
std::pair<Run, Run> overTwoMemories(const std::vector<std::string>& command) {
  return {runTool(command, {{{"MALLOC_PERTURB_", "1"}}, "", "", 0, 60.0}),
          runTool(command, {{{"MALLOC_PERTURB_", "99"}}, "", "", 0, 60.0})};
}

}  // namespace

TEST_CASE("PictureInput, AGradientsHeaderIsSaidAndCounted") {
  const Folder folder;
  folder.write("a.hdr", radiance("EXPOSURE=2\n"));
  const std::string sky = folder.write(
      "my.toml",
      skyText(kUniform + "\ngradient_sun = \"a.hdr\"\ngradient_anti = [1, 1, 1]\npolarising_tint = \"a.hdr\""));
  const Run baked = runTool({"bake", sky, "-o", folder / "out", "--progress", "none", "--certify", "none"});
  INFO(baked.err);
  REQUIRE(baked.status == 0);
  const json warnings = json::parse(readBytes(folder / "out/report.json"))["warnings"];
  REQUIRE(warnings.size() == 2);
  REQUIRE(warnings[0]["id"] == "picture");
  REQUIRE(warnings[0]["count"] == 1);
  REQUIRE(warnings[0]["message"] ==
          "my.toml:4: sky.gradient_sun = 'a.hdr': values were divided by EXPOSURE and COLORCORR, together 2 2 2");
  REQUIRE(warnings[1]["message"].get<std::string>().starts_with("my.toml:6: sky.polarising_tint = 'a.hdr': "));
  std::string said;
  for (const json& warning : warnings) said += "welkin: warning: " + warning["message"].get<std::string>() + "\n";
  REQUIRE(baked.err == said);
  const Run planned = runTool({"plan", sky, "--json"});
  REQUIRE(json::parse(planned.out)["warnings"] == warnings);
  REQUIRE(planned.err == said);
  REQUIRE(runTool({"validate", sky, folder / "out"}).err == said);
}

TEST_CASE("PictureInput, AGradientIsDividedByItsExposure") {
  const Folder folder;
  folder.write("plain.hdr", radiance(""));
  folder.write("half.hdr", radiance("EXPOSURE=0.5\n"));
  const auto red = [&](const std::string& name) {
    const Run run = runTool({"project", folder / name, "--bands", "1", "--json"});
    REQUIRE(run.status == 0);
    return double{json::parse(run.out)["radiance_sh"]["r"][0]};
  };
  REQUIRE(red("plain.hdr") == Approx(3.544908 * 127.5 / 128.0).epsilon(1e-6));  // a mantissa m stands for m + 1/2
  REQUIRE(red("half.hdr") == Approx(2.0 * red("plain.hdr")).epsilon(1e-12));
}

TEST_CASE("PictureInput, NumbersThatCannotBeAreRefused") {
  for (const char* largest : {"0", "-1", "65536"})
    requireRefused("a.ppm", std::string("P5 2 1 ") + largest + "\naa", "1 to 65535 are allowed");
  requireRefused("a.ppm", "P5 0 1 255\naa", "a side are allowed");
  requireRefused("a.ppm", "P5 -2 1 255\naa", "a side are allowed");
  requireRefused("a.pfm", std::string("Pf 2 1 0\n") + std::string(8, '\0'), "the scale is not");
  requireRefused("a.hdr", radiance("EXPOSURE=0\n"), "EXPOSURE is 0; numbers above 0");
  requireRefused("a.hdr", radiance("EXPOSURE=-2\n"), "EXPOSURE is -2; numbers above 0");
  requireRefused("a.hdr", radiance("COLORCORR=1 0 1\n"), "COLORCORR is 0; numbers above 0");
}

TEST_CASE("PictureInput, ABrokenHeaderOfAPngIsOneLine") {
  const std::vector<std::string> row = {std::string(6, '\1')};
  requireRefused("a.png", pngOf(0, 0, 8, 2, {}, row), "damaged or cut");
  requireRefused("a.png", pngOf(0x80000000U, 1, 8, 2, {}, row), "damaged or cut");
  requireRefused("a.png", pngOf(2, 1, 3, 2, {}, row), "damaged or cut");
  requireRefused("a.png", pngOf(2, 1, 8, 7, {}, row), "damaged or cut");
  requireRefused("a.png", pngOf(2, 2, 8, 2, {}, row), "damaged or cut");  // a row too few
  std::string wrong_sum = pngOf(2, 1, 8, 2, {}, row);
  wrong_sum[30] = static_cast<char>(wrong_sum[30] + 1);  // in IHDR's checksum
  requireRefused("a.png", wrong_sum, "damaged or cut");
}

TEST_CASE("PictureInput, CutGradientsAreRefusedWhateverTheMemoryHeld") {
  for (const auto& [name, bytes] : formats()) {
    const Folder folder;
    const std::string sky = folder.write("sky.toml", skyText(kUniform + "\ngradient_sun = \"" + name + "\""));
    for (const std::size_t size : {bytes.size() * 3 / 5, bytes.size() - 1}) {
      folder.write(name, bytes.substr(0, size));
      const auto [one, other] = overTwoMemories({"plan", sky});
      INFO(name << " cut to " << size << " of " << bytes.size() << ": " << one.err);
      REQUIRE(one.status == 3);
      REQUIRE(isOneLine(one));
      REQUIRE(one.said(name));
      REQUIRE(other.status == 3);
      REQUIRE(other.err == one.err);
    }
  }
}

TEST_CASE("PictureInput, WholeAndDamagedPicturesShowNoOldMemory") {
  for (const auto& [name, bytes] : formats()) {
    const Folder folder;
    std::string damaged = bytes;
    for (std::size_t at = bytes.size() / 2; at < bytes.size() / 2 + 4; ++at)
      damaged[at] = static_cast<char>(~bytes[at]);
    for (const std::string& content : {bytes, damaged}) {
      const std::string picture = folder.write(name, content);
      const auto [one, other] = overTwoMemories({"project", picture, "--json"});
      INFO(name << (content == bytes ? "" : ", damaged") << ": " << one.err);
      REQUIRE((content == bytes ? one.status == 0 : one.status == 0 || one.status == 3));
      REQUIRE(other.status == one.status);
      REQUIRE(other.out == one.out);
      REQUIRE(other.err == one.err);
    }
  }
}
