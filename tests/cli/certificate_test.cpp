// SPDX-License-Identifier: Apache-2.0
// A bake's certificate: true where closed forms are known, and the same in every place.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "baked.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string kSmall = "keys = 6\ncubemap_size = 0";
constexpr double kQuadrature = 1e-5;  // Bound of a bake's moments, relative to the mean.
constexpr double kReference = 8e-5;   // IrradianceProjector::kError, of the reference of a fast certificate.
constexpr double kSearch = 1e-2;      // Relative: the tested normals miss the peak of an error by this much.

std::string smallSky(const Folder& folder, const std::string& bake = kSmall) {
  return folder.write("sky.toml", skyText(kDay, kDaySun, bake));
}

/// The lines of a run's stderr.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace

TEST_CASE("Certificate, TwoBandsHoldAUniformSky") {
  const Folder folder;
  const json c = bakeReport(folder.write("sky.toml", skyText(kUniform)), folder / "out")["certificate"];
  REQUIRE(c["max_error"] < kReference);  // the irradiance of a hemisphere, pi (1 + n_y) / 2, has two bands
}

TEST_CASE("Certificate, OvercastSkyHasTheErrorOfItsEvenBands") {
  // L = (1 + 2 sin el) / 3: E(up) = 7 pi / 9, the mean of E is pi / 3, bands 0 and 1 give E(up) = 13 pi / 18, and band
  // 2 has 5 pi / 96 more. The sum of the missing bands is largest straight up. Straight down it is clamped at 0.
  for (const auto& [bands, error] : {std::pair(2, 1.0 / 6.0), {3, 1.0 / 96.0}}) {
    const Folder folder;
    const std::string sky =
        folder.write("sky.toml", skyText("luminance = \"cie-overcast\"\nnormalise = \"zenith\"", kStillSun,
                                         "keys = 1\ncubemap_size = 0\nbands = " + std::to_string(bands)));
    const json c = bakeReport(sky, folder / "out")["certificate"];
    INFO(c.dump());
    REQUIRE(c["max_error"].get<double>() == Approx(error).epsilon(kSearch));
    REQUIRE(c["parts"]["truncation"].get<double>() == Approx(error).epsilon(kSearch));
    REQUIRE(c["normal"][1].get<double>() > 0.99);
    REQUIRE(c["parts"]["time"] < kQuadrature);
    REQUIRE(c["parts"]["encoding"] < 1e-6);  // floats
  }
}

TEST_CASE("Certificate, SaysTheSameInReportFileAndLine") {
  const Folder folder;
  const Run run = runBake(smallSky(folder, "keys = 6\ncubemap_size = 4\ncubemap_times = 2"), folder / "out");
  INFO(run.err);
  REQUIRE(run.status == 0);
  const json report = json::parse(readBytes(folder / "out/report.json"));
  json c = report["certificate"];
  json inspected = printedJson({"inspect", folder / "out", "--json"})["sky"]["certificate"];
  for (const char* key : {"method", "max_error", "time_h", "normal", "channel", "mean_error", "parts", "dome"}) {
    INFO(key << ": " << c[key].dump());
    REQUIRE(c[key] == inspected[key]);
  }
  for (const char* key : {"max_error", "time_h", "parts"}) REQUIRE(c["cubemaps"][key] == inspected["cubemaps"][key]);
  REQUIRE(c["method"] == "fast");
  REQUIRE(c["max_error"] > 0.0);
  REQUIRE(c["mean_error"] <= c["max_error"]);
  REQUIRE(c["instants"] >= 1440);

  const auto lines = linesOf(run.err);
  REQUIRE(lines.size() == 1);
  const std::string start = "welkin: irradiance within ";
  REQUIRE(lines[0].starts_with(start));
  const double shown = std::strtod(lines[0].c_str() + start.size(), nullptr) / 100.0;
  REQUIRE(shown == Approx(c["max_error"].get<double>()).epsilon(0.005));  // three digits
  for (const char* word :
       {" h, normal ", "mean ", "quadrature ", "truncation ", "time ", "encoding ", "cubemaps within "})
    REQUIRE(run.said(word));
  REQUIRE(runTool({"inspect", folder / "out"}).out.find("irradiance within ") != std::string::npos);

  const json timing = json::parse(readBytes(folder / "out/timing.json"));
  for (const char* key : {"table_s", "certify_s", "cubemaps_s", "write_s", "total_s"}) {
    INFO(key);
    REQUIRE(timing[key] >= 0.0);
  }
}

TEST_CASE("Certificate, NoneLeavesTheRestAsItIs") {
  const Folder folder;
  const std::string sky = smallSky(folder);
  json fast = bakeReport(sky, folder / "fast", {"--certify", "fast"});
  const Run run = runBake(sky, folder / "none", {"--certify", "none"});
  REQUIRE(run.status == 0);
  REQUIRE(run.err.empty());
  json none = json::parse(readBytes(folder / "none/report.json"));
  REQUIRE_FALSE(none.contains("certificate"));
  REQUIRE(none["table"] == fast["table"]);
  json with = printedJson({"inspect", folder / "fast", "--json"});
  json without = printedJson({"inspect", folder / "none", "--json"});
  REQUIRE(without["sky"]["certificate"].is_null());
  REQUIRE_FALSE(with["sky"]["certificate"].is_null());
  with["sky"].erase("certificate");
  without["sky"].erase("certificate");
  REQUIRE(with == without);
  REQUIRE(runTool({"inspect", folder / "none"}).out.find("within") == std::string::npos);
}

TEST_CASE("Certificate, NoneStillPlansForABudget") {
  const Folder folder;
  const json report =
      bakeReport(smallSky(folder, "cubemap_size = 0"), folder / "out", {"--certify", "none", "--max-error", "0.1"});
  REQUIRE(report["table"]["predicted_error"] <= 0.1);
  REQUIRE_FALSE(report.contains("certificate"));
}

TEST_CASE("Certificate, HowIsOneOfThreeWords") {
  const Folder folder;
  const Run run = runBake(smallSky(folder), folder / "out", {"--certify", "roughly"});
  REQUIRE(run.status == 1);
  REQUIRE(run.said("--certify"));
  REQUIRE(run.said("full"));
  REQUIRE_FALSE(fs::exists(folder / "out"));
}

TEST_CASE("Certificate, BooksTheLossOfAWindowAsTruncation") {
  const Folder folder;
  const std::string bake = "cubemap_size = 0\nkeys = 1\nbands = 2\nwindow = \"mildest\"";
  const std::string sky = folder.write(
      "sky.toml", skyText("luminance = [0, -1, 10000, -30, 0]\nnormalise = \"zenith\"", "path = [[0, 180, 10]]", bake));
  const json c = bakeReport(sky, folder / "out")["certificate"];
  constexpr double kFloat = 1e-6;  // The sun stands still: between keys there are only roundings of the table.
  REQUIRE(c["parts"]["time"] < kFloat);
  REQUIRE(c["parts"]["truncation"] > 0.9 * c["max_error"].get<double>());
}

TEST_CASE("Certificate, OnlyANarrowLobeMakesItUnsure") {
  const Folder folder;
  const auto warns = [&](const std::string& sky, const std::string& bake) {
    const json report = bakeReport(
        folder.write("sky.toml", skyText(sky, "path = [[0, 180, 10]]", "cubemap_size = 0\n" + bake)), folder / "out");
    REQUIRE(report["certificate"]["reference_error"] > 0.05 * report["certificate"]["max_error"].get<double>());
    for (const json& warning : report["warnings"])
      if (warning["id"] == "certificate-unsure") return true;
    return false;
  };
  REQUIRE_FALSE(warns(kUniform, "keys = 1"));
  REQUIRE(warns("luminance = [0, -1, 10000, -30, 0]\nnormalise = \"zenith\"", "max_error = 0.02"));
}
