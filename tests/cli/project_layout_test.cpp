// SPDX-License-Identifier: Apache-2.0
// welkin project: every layout asked for by its name, layers of OpenEXR files, six faces, and choices that do not fit.
#include <OpenImageIO/imageio.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "run_tool.h"
#include "sh/deterministic.h"
#include "sky/cubemap/cubemap.h"

using namespace welkin::tests;
using nlohmann::json;
using welkin::det::Number3;
using DirectionOf = std::function<Number3(int column, int row)>;

namespace {

constexpr int kSize = 24;  // texels of a face

/// Red 1 + x/2, green 1 + y/2, blue 1 + z/2, as PFM: rows from the bottom, little-endian floats. Black where the
/// direction is zero.
std::string linearPicture(int width, int height, const DirectionOf& direction) {
  std::string text = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1\n";
  for (int row = height - 1; row >= 0; --row)
    for (int column = 0; column < width; ++column) {
      const Number3 d = direction(column, row);
      const double size = std::sqrt(dot(d, d));
      for (int c = 0; c < 3; ++c) {
        const float value = size > 0.0 ? static_cast<float>(1.0 + 0.5 * d[c] / size) : 0.0F;
        char raw[4];
        std::memcpy(raw, &value, 4);
        text.append(raw, 4);
      }
    }
  return text;
}

/// 2 sqrt(pi), and sqrt(pi / 3) in the term of the channel's own axis. The texels' interpolation costs 2.1 / N^2.
void requireLinear(const json& sh) {
  const double tolerance = 3.0 / (kSize * kSize);
  for (int c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < 4; ++k) {
      const bool own = k == std::array<std::size_t, 3>{3, 1, 2}[static_cast<std::size_t>(c)];
      const double expected = k == 0 ? 3.544908 : own ? 1.023327 : 0.0;
      CAPTURE(c, k);
      REQUIRE(double{sh[std::string(1, "rgb"[c])][k]} == Approx(expected).margin(tolerance));
    }
}

Number3 axis(const std::string& text) {
  const double sign = text[0] == '+' ? 1.0 : -1.0;
  return text[1] == 'x' ? Number3(sign, 0.0, 0.0) : Number3(0.0, 0.0, sign);
}

double place(int i) {
  return (2 * (i % kSize) + 1.0) / kSize - 1.0;
}

/// A cross from the faces in its middle and right of it, by the drawing in docs/pictures.md.
DirectionOf crossOf(bool across, const std::string& middle_axis, const std::string& right_axis, bool upright) {
  return [=](int column, int row) {
    const Number3 middle = axis(middle_axis), right = axis(right_axis), up(0.0, 1.0, 0.0);
    const int i = column / kSize, j = row / kSize;
    const double s = place(column), t = place(row);
    if (j == 1 && i == 0) return right * -1.0 + middle * s - up * t;
    if (j == 1 && i == 1) return middle + right * s - up * t;
    if (j == 1 && i == 2) return right - middle * s - up * t;
    if (j == 1 && i == 3) return middle * -1.0 - right * s - up * t;
    if (i == 1 && j == 0) return up + right * s + middle * t;
    if (i == 1 && j == 2) return up * -1.0 + right * s - middle * t;
    if (!across && i == 1) return middle * -1.0 + (right * s + up * t) * (upright ? -1.0 : 1.0);
    return Number3(0.0);
  };
}

Number3 vulkanFace(int face, double s, double t) {
  const std::array<Number3, 6> direction = {Number3(1.0, -t, -s), Number3(-1.0, -t, s), Number3(s, 1.0, t),
                                            Number3(s, -1.0, -t), Number3(s, -t, 1.0),  Number3(-s, -t, -1.0)};
  return direction[static_cast<std::size_t>(face)];
}

struct Asked {
  std::string layout;
  int width, height;
  DirectionOf direction;
};

std::vector<Asked> layouts() {
  using welkin::cubemap::Layout;
  const int n = kSize;
  const auto latlong = [](int column, int row) {
    const double longitude = M_PI * (1.0 - (column + 0.5) / (2 * kSize)),
                 latitude = M_PI * (0.5 - (row + 0.5) / (2 * kSize));
    return Number3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                   std::cos(latitude) * std::cos(longitude));
  };
  const auto exr = [](Layout layout) {
    return [layout](int column, int row) { return welkin::cubemap::directionOfTexel(layout, kSize, column, row); };
  };
  return {
      {"latlong", 4 * n, 2 * n, latlong},
      {"exr-latlong", 4 * n, 2 * n, exr(Layout::exr_latlong)},
      {"vstrip", n, 6 * n, [](int column, int row) { return vulkanFace(row / kSize, place(column), place(row)); }},
      {"hstrip", 6 * n, n, [](int column, int row) { return vulkanFace(column / kSize, place(column), place(row)); }},
      {"exr-cube", n, 6 * n, exr(Layout::exr_cube)},
      {"hcross", 4 * n, 3 * n, crossOf(true, "+z", "+x", false)},
      {"hcross:-z+x", 4 * n, 3 * n, crossOf(true, "-z", "+x", false)},
      {"hcross:+x-z", 4 * n, 3 * n, crossOf(true, "+x", "-z", false)},
      {"vcross", 3 * n, 4 * n, crossOf(false, "+z", "+x", false)},
      {"vcross:-z-x", 3 * n, 4 * n, crossOf(false, "-z", "-x", false)},
      {"vcross:+z+x:upright", 3 * n, 4 * n, crossOf(false, "+z", "+x", true)}};
}

}  // namespace

TEST_CASE("ProjectLayout, EachByItsNameOnceRightAndOnceRefused") {
  const Folder folder;
  const std::string square = folder.write("square.pfm", linearPicture(5, 5, [](int, int) { return Number3(0.0); }));
  for (const Asked& asked : layouts()) {
    INFO(asked.layout);
    const std::string picture = folder.write("a.pfm", linearPicture(asked.width, asked.height, asked.direction));
    const Run run = runTool({"project", picture, "--layout", asked.layout, "--bands", "2", "--json"});
    INFO(run.err);
    REQUIRE(run.status == 0);
    REQUIRE(run.err.empty());
    const json said = json::parse(run.out);
    REQUIRE(said["layout"] == asked.layout);
    requireLinear(said["radiance_sh"]);
    if (asked.layout.ends_with("latlong")) continue;  // fits any shape
    const Run refused = runTool({"project", square, "--layout", asked.layout});
    REQUIRE(refused.status == 3);
    REQUIRE(refused.said("square.pfm: 5 x 5 texels: " + asked.layout + " is "));
  }
}

TEST_CASE("ProjectLayout, ACrossReadByItsShapeSaysHow") {
  const Folder folder;
  for (const Asked& asked : layouts()) {
    if (asked.layout != "hcross" && asked.layout != "vcross" && asked.layout != "vcross:+z+x:upright") continue;
    const std::string picture = folder.write("a.pfm", linearPicture(asked.width, asked.height, asked.direction));
    const Run run = runTool({"project", picture, "--bands", "2", "--json"});
    REQUIRE(run.status == 0);
    REQUIRE(run.said("welkin: warning: " + picture + ": no field says which face of a cross is in its middle"));
    const json said = json::parse(run.out);
    requireLinear(said["radiance_sh"]);
    REQUIRE(said["warnings"].size() == (asked.layout.ends_with("upright") ? 2U : 1U));
    REQUIRE(said["warnings"][0]["id"] == "picture");
  }
}

TEST_CASE("ProjectLayout, SixFaces") {
  const Folder folder;
  std::vector<std::string> command = {"project"};
  for (int face = 0; face < 6; ++face)
    command.push_back(
        folder.write(std::to_string(face) + ".pfm", linearPicture(kSize, kSize, [face](int column, int row) {
                       return vulkanFace(face, place(column), place(row));
                     })));
  std::vector<std::string> whole = command;
  whole.insert(whole.end(), {"--bands", "2", "--json"});
  const Run run = runTool(whole);
  REQUIRE(run.status == 0);
  REQUIRE(run.err.empty());
  REQUIRE(json::parse(run.out)["layout"] == "faces");
  requireLinear(json::parse(run.out)["radiance_sh"]);

  std::vector<std::string> with_layout = command;
  with_layout.insert(with_layout.end(), {"--layout", "vstrip"});
  REQUIRE(runTool(with_layout).status == 1);
  const Run two = runTool({"project", command[1], command[2]});
  REQUIRE(two.status == 1);
  REQUIRE(two.said("one picture, or six faces"));
  folder.write("3.pfm", linearPicture(4, 4, [](int, int) { return Number3(0.0); }));
  const Run other_size = runTool(command);
  REQUIRE(other_size.status == 3);
  REQUIRE(other_size.said("3.pfm: 4 x 4 texels: the first face has 24 x 24"));
}

TEST_CASE("ProjectLayout, UnknownNamesAreUsageErrors") {
  const Folder folder;
  const std::string picture = folder.write("a.pfm", linearPicture(4, 3, [](int, int) { return Number3(0.0); }));
  for (const char* layout : {"cross", "hcross:+z+z", "hcross:+z", "hcross:+z+x:upright", "LATLONG"}) {
    const Run run = runTool({"project", picture, "--layout", layout});
    INFO(layout << ": " << run.err);
    REQUIRE(run.status == 1);
    REQUIRE(run.said(std::string("no layout '") + layout + "': latlong, exr-latlong, vstrip, hstrip, exr-cube"));
  }
}

TEST_CASE("ProjectLayout, LayersOfOpenExr") {
  const Folder folder;
  OIIO::ImageSpec spec(2, 1, 6, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"V.Combined.R", "V.Combined.G", "V.Combined.B", "V.Emit.R", "V.Emit.G", "V.Emit.B"};
  const std::string picture = folder / "a.exr";
  const auto output = OIIO::ImageOutput::create(picture);
  REQUIRE(output->open(picture, spec));
  const std::array<float, 12> texels = {1, 1, 1, 5, 5, 5, 1, 1, 1, 5, 5, 5};
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, texels.data()));
  REQUIRE(output->close());
  const auto constant = [&](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"project", picture, "--bands", "1", "--json"};
    command.insert(command.end(), more.begin(), more.end());
    const Run run = runTool(command);
    INFO(run.err);
    REQUIRE(run.status == 0);
    REQUIRE(run.said("welkin: warning: " + picture + ": layer read: "));
    return double{json::parse(run.out)["radiance_sh"]["r"][0]} / 3.544908;
  };
  REQUIRE(constant({}) == Approx(1.0).epsilon(1e-6));
  REQUIRE(constant({"--layer", "V.Emit"}) == Approx(5.0).epsilon(1e-6));
  const Run refused = runTool({"project", picture, "--layer", "V.Depth"});
  REQUIRE(refused.status == 3);
  REQUIRE(refused.said("no layer 'V.Depth' with colours, or several; the layers are 'V.Combined', 'V.Emit'"));
  const std::string flat = folder.write("a.ppm", "P3 2 1 1 1 1 1 1 1 1");
  REQUIRE(runTool({"project", flat, "--layer", "x"}).said("a.ppm: no layer 'x': only OpenEXR has layers"));
}
