// SPDX-License-Identifier: Apache-2.0
// welkin gloss: its files as OpenImageIO reads them, its report, and its messages.
#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "run_tool.h"
#include "tests/sky/png_bytes.h"

namespace welkin::tests {
namespace {

/// A PNG of two slopes that alternate along x: +-30 degrees, whose mean is cos 30 degrees long.
std::string ridges(std::uint32_t width, std::uint32_t height, bool flat = false) {
  std::vector<std::string> rows;
  for (std::uint32_t y = 0; y < height; ++y) {
    std::string row;
    for (std::uint32_t x = 0; x < width; ++x)
      row += flat ? std::string("\x80\x80\xff") : std::string(x % 2 == 0 ? "\xbf\x80\xee" : "\x40\x80\xee");
    rows.push_back(row);
  }
  return pngOf(width, height, 8, 2, {}, rows);
}

struct Texels {
  int width = 0, height = 0, channels = 0;
  std::vector<float> value;
};

Texels readTexels(const std::string& path) {
  const auto file = OIIO::ImageInput::open(path);
  REQUIRE(file);
  Texels texels{file->spec().width, file->spec().height, file->spec().nchannels, {}};
  texels.value.resize(static_cast<std::size_t>(texels.width * texels.height * texels.channels));
  REQUIRE(file->read_image(0, 0, 0, texels.channels, OIIO::TypeDesc::FLOAT, texels.value.data()));
  return texels;
}

}  // namespace

TEST_CASE("Gloss, WritesEveryMipOfNormalsAndGloss") {
  const Folder folder;
  const Run run = runTool(
      {"gloss", folder.write("brick.png", ridges(8, 6)), "--gloss", "0.7", "-o", folder / "out", "--format", "exr"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  REQUIRE(run.err.empty());
  REQUIRE(filesUnder(folder / "out") ==
          std::vector<std::string>{"brick_gloss_mip0.exr", "brick_gloss_mip1.exr", "brick_gloss_mip2.exr",
                                   "brick_gloss_mip3.exr", "brick_normal_mip0.exr", "brick_normal_mip1.exr",
                                   "brick_normal_mip2.exr", "brick_normal_mip3.exr", "report.json"});
  const Texels gloss0 = readTexels(folder / "out/brick_gloss_mip0.exr");
  REQUIRE(gloss0.channels == 1);
  for (const float g : gloss0.value) REQUIRE(g == 0.7F);
  const double m = std::pow(2.0, 13.0 * 0.7), na = std::sqrt(0.75);
  const double expected = std::log2(na * m / (na + m * (1.0 - na))) / 13.0;
  for (int k = 1; k < 4; ++k) {
    const Texels gloss = readTexels(folder / ("out/brick_gloss_mip" + std::to_string(k) + ".exr"));
    REQUIRE(gloss.width == 8 >> k);
    // Codes of 8 bits put the slopes 0.4 degrees off, and the power of 6.4 changes by 3 % a degree.
    for (const float g : gloss.value) REQUIRE(double{g} == Approx(expected).margin(5e-3));
    const Texels normal = readTexels(folder / ("out/brick_normal_mip" + std::to_string(k) + ".exr"));
    for (std::size_t i = 0; i < normal.value.size(); i += 3) REQUIRE(normal.value[i + 2] == Approx(1.0F).margin(1e-4));
  }
  const auto report = nlohmann::json::parse(readBytes(folder / "out/report.json"));
  REQUIRE(report["coding"] == "codes");
  REQUIRE(report["mips"].size() == 4);
  REQUIRE(report["files"].size() == 8);
  REQUIRE(double{report["average_toksvig"]["gloss"]} == Approx(expected).margin(5e-3));
  REQUIRE(report["warnings"].empty());
}

TEST_CASE("Gloss, PngOfEightAndSixteenBits") {
  const Folder folder;
  const std::string brick = folder.write("brick.png", ridges(4, 4));
  for (const auto& [format, tolerance] : {std::pair("png", 0.5 / 255.0), {"png16", 0.5 / 65535.0}}) {
    REQUIRE(runTool({"gloss", brick, "--gloss", "0.7", "-o", folder / format, "--format", format}).status == 0);
    const Texels gloss = readTexels(folder / (std::string(format) + "/brick_gloss_mip0.png"));
    REQUIRE(double{gloss.value[0]} == Approx(0.7).margin(tolerance + 1e-7));
    const Texels normal = readTexels(folder / (std::string(format) + "/brick_normal_mip0.png"));
    REQUIRE(double{normal.value[0]} == Approx(0.75).margin(3e-3));  // (sin 30 + 1) / 2, from 8 bits
  }
}

TEST_CASE("Gloss, NeverWritesOverItsInput") {
  const Folder folder;
  const std::string brick = folder.write("brick.png", ridges(4, 4));
  const std::string map = folder.write("brick_gloss_mip0.png", ridges(4, 4));
  const Run run = runTool({"gloss", brick, "--gloss", map, "-o", folder.path().string(), "--format", "png"});
  CHECK(run.status == 1);
  CHECK(run.said("brick_gloss_mip0.png is an input and would be overwritten"));
  CHECK(readBytes(map) == ridges(4, 4));
}

TEST_CASE("Gloss, DdsFilesSayWhatRedCostsY") {
  const Folder folder;
  const std::string brick = folder.write("brick.png", ridges(16, 16));
  std::vector<std::string> rows;  // gloss that no line of colours in a block follows
  for (int y = 0; y < 16; ++y) {
    std::string row;
    for (int x = 0; x < 16; ++x) row += static_cast<char>((x * 97 + y * 57) % 256);
    rows.push_back(row);
  }
  const std::string gloss = folder.write("noise.png", pngOf(16, 16, 8, 0, {}, rows));
  const Run three = runTool({"gloss", brick, "--gloss", gloss, "-o", folder / "bc3", "--format", "bc3"});
  INFO(three.err);
  REQUIRE(three.status == 0);
  REQUIRE(filesUnder(folder / "bc3") == std::vector<std::string>{"brick_normal.dds", "report.json"});
  REQUIRE(three.out.find("red holds the gloss map") != std::string::npos);
  const auto blocks = nlohmann::json::parse(readBytes(folder / "bc3/report.json"))["blocks"];
  REQUIRE(blocks["red"] == "map");
  REQUIRE(double{blocks["with_map"]["gloss_rms"]} < double{blocks["with_average"]["gloss_rms"]});
  REQUIRE(double{blocks["with_map"]["y_rms"]} > double{blocks["with_average"]["y_rms"]});
  const Texels texels = readTexels(folder / "bc3/brick_normal.dds");
  REQUIRE(texels.width == 16);
  REQUIRE(double{texels.value[3]} == Approx(0.75).margin(3e-3));  // x in alpha
  const Run chosen =
      runTool({"gloss", brick, "--gloss", gloss, "-o", folder / "bc3", "--format", "bc3", "--max-error", "0.001"});
  REQUIRE(chosen.status == 0);
  REQUIRE(chosen.out.find("red holds the average") != std::string::npos);
  REQUIRE(runTool({"gloss", brick, "--gloss", gloss, "-o", folder / "bc5", "--format", "bc5"}).status == 0);
  REQUIRE(filesUnder(folder / "bc5") == std::vector<std::string>{"brick_gloss.dds", "brick_normal.dds", "report.json"});
  REQUIRE(
      runTool({"gloss", brick, "--gloss", "1", "-o", folder / "bc5", "--format", "bc5", "--max-error", "1"}).status ==
      1);
}

TEST_CASE("Gloss, SameBytesForAnyNumberOfThreads") {
  const Folder folder;
  const std::string brick = folder.write("brick.png", ridges(61, 35));
  REQUIRE(runTool({"gloss", brick, "--gloss", "0.8", "-o", folder / "one", "--threads", "1"}).status == 0);
  REQUIRE(runTool({"gloss", brick, "--gloss", "0.8", "-o", folder / "all"}).status == 0);
  for (const std::string& name : filesUnder(folder / "one"))
    REQUIRE(readBytes(folder / ("one/" + name)) == readBytes(folder / ("all/" + name)));
}

TEST_CASE("Gloss, MapsOfGlossAndRoughness") {
  const Folder folder;
  const std::string flat = folder.write("flat.png", ridges(2, 2, true));
  const std::string half = folder.write("half.png", pngOf(1, 1, 8, 0, {}, {std::string("\x80")}));
  const auto first = [&](const std::string& option, const std::string& value) {
    const Run run = runTool({"gloss", flat, option, value, "-o", folder / "out"});
    INFO(run.err);
    REQUIRE(run.status == 0);
    return double{readTexels(folder / "out/flat_gloss_mip0.exr").value[0]};
  };
  REQUIRE(first("--gloss", half) == Approx(128.0 / 255.0).epsilon(1e-6));
  const double r = 128.0 / 255.0;
  REQUIRE(first("--roughness", half) == Approx(std::log2(2.0 / std::pow(r, 4.0) - 2.0) / 13.0).epsilon(1e-6));
  REQUIRE(first("--roughness", "0.5") == Approx(std::log2(30.0) / 13.0).epsilon(1e-6));
  const std::string rough = folder.write("brick_roughness.png", pngOf(1, 1, 8, 0, {}, {std::string("\x80")}));
  const Run swapped = runTool({"gloss", flat, "--gloss", rough, "-o", folder / "out"});
  REQUIRE(swapped.status == 0);
  REQUIRE(swapped.said("the name says roughness, and it is read as gloss; pass it with --roughness instead?"));
}

TEST_CASE("Gloss, AFolderIsMadeOnce") {
  const Folder folder;
  const std::string noise = pngOf(1, 1, 8, 0, {}, {std::string("\x80")});
  folder.write("in/brick_normal.png", ridges(8, 8));
  folder.write("in/brick_gloss.png", noise);
  folder.write("in/Wall_N.PNG", ridges(4, 4));
  folder.write("in/wall_roughness.png", noise);
  folder.write("in/notes.txt", "hello");
  const auto make = [&](std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"gloss", folder / "in", "-o", folder / "out", "--depfile", folder / "d"});
    const Run run = runTool(more);
    INFO(run.err);
    REQUIRE(run.status == 0);
    return run;
  };
  REQUIRE_FALSE(make().said("up to date"));
  REQUIRE(readBytes(folder / "d") == folder / "out/report.json: " + folder / "in/Wall_N.PNG " +
                                         folder / "in/wall_roughness.png " + folder / "in/brick_normal.png " +
                                         folder / "in/brick_gloss.png\n");
  const std::string report = readBytes(folder / "out/report.json");
  const auto json = nlohmann::json::parse(report);
  REQUIRE(json["textures"].size() == 2);
  REQUIRE(json["textures"][1]["gloss"] == "brick_gloss.png");
  REQUIRE(json["failed"].empty());
  const Run second = make();
  REQUIRE(second.said("brick_normal.png: up to date"));
  REQUIRE(second.said("Wall_N.PNG: up to date"));
  REQUIRE(readBytes(folder / "out/report.json") == report);
  // A changed input, a damaged output, other options and --force are each made anew.
  folder.write("in/brick_gloss.png", pngOf(1, 1, 8, 0, {}, {std::string("\x90")}));
  flipBit(folder / "out/Wall_N_gloss_mip0.exr", 100);
  const Run third = make();
  REQUIRE_FALSE(third.said("up to date"));
  REQUIRE(make().said("brick_normal.png: up to date"));
  REQUIRE_FALSE(make({"--force"}).said("up to date"));
  REQUIRE_FALSE(make({"--flip-green"}).said("up to date"));
}

TEST_CASE("Gloss, ATextureThatFailsDoesNotKeepOthersFromTheirFiles") {
  const Folder folder;
  folder.write("in/a_normal.png", "hello");
  folder.write("in/b_normal.png", ridges(4, 4));
  const Run run = runTool({"gloss", folder / "in", "--gloss", "0.5", "-o", folder / "out"});
  REQUIRE(run.status == 3);
  REQUIRE(run.said("a_normal.png: not a picture of codes"));
  REQUIRE(run.said("1 of 2 textures failed"));
  REQUIRE(readTexels(folder / "out/b_normal_gloss_mip0.exr").value[0] == 0.5F);
  const auto report = nlohmann::json::parse(readBytes(folder / "out/report.json"));
  REQUIRE(report["textures"].size() == 1);
  REQUIRE(report["failed"][0]["normal"] == "a_normal.png");
  const Run none = runTool({"gloss", folder / "in", "-o", folder / "out"});
  REQUIRE(none.status == 3);
  REQUIRE(none.said("no a_gloss or a_roughness beside it"));
  folder.write("empty/x.png", ridges(4, 4));
  const Run empty = runTool({"gloss", folder / "empty", "--gloss", "0.5", "-o", folder / "out"});
  REQUIRE(empty.status == 3);
  REQUIRE(empty.said("no normal maps"));
  folder.write("in/b_normal.bmp", "x");
  REQUIRE(runTool({"gloss", folder / "in", "--gloss", "0.5", "-o", folder / "out"})
              .said("the same name but for its ending"));
}

TEST_CASE("Gloss, BadInputIsOneLineThatNamesIt") {
  const Folder folder;
  const std::string flat = folder.write("flat.png", ridges(2, 2, true));
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& part) {
    arguments.insert(arguments.begin(), "gloss");
    arguments.insert(arguments.end(), {"-o", folder / "out"});
    const Run run = runTool(arguments);
    INFO(run.err);
    REQUIRE(run.status == status);
    REQUIRE(run.said(part));
    REQUIRE(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  };
  refused({flat}, 1, "--gloss or --roughness");
  refused({flat, "--gloss", "0.5", "--roughness", "0.5"}, 1, "not both");
  for (const char* number : {"1.5", "-0.1", "nan"}) refused({flat, "--gloss", number}, 1, "is not in [0, 1]");
  refused({flat, "--gloss", folder / "none.png"}, 2, "none.png");
  refused({folder / "none.png", "--gloss", "0.5"}, 2, "none.png");
  refused({folder.write("text.png", "hello"), "--gloss", "0.5"}, 3, "text.png: not a picture of codes");
  refused({folder.write("grey.png", pngOf(1, 1, 8, 0, {}, {std::string("\x80")})), "--gloss", "0.5"}, 3,
          "red, green and blue are equal");
  refused({flat, "--gloss", "0.5", "--format", "jpeg"}, 1, "--format");
}

}  // namespace welkin::tests
