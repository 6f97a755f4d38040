// SPDX-License-Identifier: Apache-2.0
// Error budgets on the command line and in the file: kept, or refused when impossible. Choices fixed in the file stay.
#include <catch2/catch.hpp>
#include <string>

#include "baked.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string kNoCubemaps = "cubemap_size = 0";

json planOf(const std::string& sky, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"plan", sky, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return printedJson(arguments);
}

/// Requires a bake to end with status 3 and these words, and to leave a folder unchanged.
void requireCannot(const Folder& folder, const std::string& sky, const std::vector<std::string>& more,
                   const std::vector<std::string>& said) {
  const auto before = filesUnder(folder / "out");
  std::vector<std::string> bytes;
  for (const auto& name : before) bytes.push_back(readBytes(folder.path() / "out" / name));
  const Run run = runBake(sky, folder / "out", more);
  INFO(run.err);
  REQUIRE(run.status == 3);
  REQUIRE(run.said(sky + ": "));
  for (const auto& part : said) {
    INFO(part);
    REQUIRE(run.said(part));
  }
  REQUIRE(filesUnder(folder / "out") == before);
  for (std::size_t i = 0; i < before.size(); ++i) REQUIRE(readBytes(folder.path() / "out" / before[i]) == bytes[i]);
}

}  // namespace

TEST_CASE("Budget, IsKeptByWhatABakeMeasures") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps));
  double before = 1e9;
  for (const double budget : {0.1, 0.03}) {
    const json report = bakeReport(sky, folder / "out", {"--max-error", std::to_string(budget)});
    INFO(report.dump());
    REQUIRE(report["table"]["max_error"] == budget);
    REQUIRE(report["table"]["predicted_error"] <= budget);
    REQUIRE(report["certificate"]["max_error"] <= budget);
    REQUIRE(report["certificate"]["max_error"] < before);
    REQUIRE(report["certificate"]["max_error"] > 0.2 * budget);  // and spends no more than needed
    before = report["certificate"]["max_error"];
    REQUIRE(report["settings"]["bake"].contains("max_error") == false);  // the file's own settings
    REQUIRE(runTool({"validate", folder / "out"}).status == 0);
  }
}

TEST_CASE("Budget, ChoosesCubemapsToo") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, ""));
  const json report = bakeReport(sky, folder / "out", {"--quality", "draft"});
  INFO(report.dump());
  REQUIRE(report["cubemaps"]["time_h"].size() > 1);
  REQUIRE(report["cubemaps"]["format"] != "rgba16f");
  REQUIRE(report["certificate"]["cubemaps"]["max_error"] <= 0.1);
  REQUIRE(report["certificate"]["max_error"] <= 0.1);
}

TEST_CASE("Budget, OfCubemapsIsTheirOwn") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, "cubemap_error = 0.2"));
  const json report = bakeReport(sky, folder / "out", {"--max-error", "0.05"});
  INFO(report.dump());
  REQUIRE(report["certificate"]["max_error"] <= 0.05);
  REQUIRE(report["certificate"]["cubemaps"]["max_error"] <= 0.2);
  REQUIRE(report["certificate"]["cubemaps"]["max_error"] > 0.1);
  const auto cubemapsOf = [&](const std::vector<std::string>& more) { return planOf(sky, more)["cubemaps"]; };
  REQUIRE(cubemapsOf({})["predicted_error"] <= 0.2);  // also where the table has the default budget
  REQUIRE(cubemapsOf({"--cubemaps", "none"})["count"] == 0);
  REQUIRE(cubemapsOf({"--cubemaps", "0.3"})["bytes"] < report["cubemaps"]["bytes"]);
  const std::string fixed =
      folder.write("fixed.toml", skyText(kDay, kDaySun, "keys = 2\ncubemap_size = 2\ncubemap_times = 2"));
  REQUIRE(planOf(fixed, {"--cubemaps", "0.3"})["cubemaps"]["predicted_error"] <= 0.3);
}

TEST_CASE("Budget, CubemapsThatCostTooMuchKeepToTheirBytesAndSaySo") {
  const Folder folder;
  const std::string sky = folder.write(
      "sky.toml", skyText("luminance = \"cie-15\"\nnormalise = \"sun\"", "latitude_deg = 0\nday_of_year = 80", ""));
  const json plan = planOf(sky, {"--max-error", "0.004"});
  INFO(plan["cubemaps"].dump() << plan["warnings"].dump());
  REQUIRE(plan["cubemaps"]["bytes"] <= 64e6);
  REQUIRE(plan["cubemaps"]["predicted_error"] > 0.004);
  REQUIRE(plan["warnings"].size() == 1);
  REQUIRE(plan["warnings"][0]["id"] == "cubemaps-over-budget");
  const std::string message = plan["warnings"][0]["message"];
  for (const char* part : {"64 MB", "0.4 %", "cubemap_error", "--cubemaps none"}) {
    INFO(part << " in " << message);
    REQUIRE(message.find(part) != std::string::npos);
  }
}

TEST_CASE("Budget, QualitiesHaveNames") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, kNoCubemaps));
  for (const auto& [name, budget] : {std::pair("draft", 0.1), {"preview", 0.03}, {"final", 0.01}})
    REQUIRE(planOf(sky, {"--quality", name})["table"]["max_error"] == budget);
  const Run help = runTool({"bake", "--help"});
  REQUIRE(help.out.find("draft 10 %, preview 3 %, final 1 %") != std::string::npos);
}

TEST_CASE("Budget, TheOptionWinsOverTheFile") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, kNoCubemaps + "\nmax_error = 0.5"));
  REQUIRE(planOf(sky)["table"]["max_error"] == 0.5);
  REQUIRE(planOf(sky, {"--max-error", "0.25"})["table"]["max_error"] == 0.25);
  REQUIRE(planOf(sky, {"--quality", "final"})["table"]["max_error"] == 0.01);
}

TEST_CASE("Budget, WrongOptionsAreUsage") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  for (const char* command : {"bake", "plan"})
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--max-error", "0"},
                                                    {"--max-error", "2"},
                                                    {"--max-error", "nan"},
                                                    {"--max-error", "-0.1"},
                                                    {"--max-error", "1 %"},
                                                    {"--max-error", "9e-6"},
                                                    {"--quality", "best"},
                                                    {"--cubemaps", "some"},
                                                    {"--cubemaps", "0"},
                                                    {"--cubemaps", "nan"},
                                                    {"--cubemaps", "1.5"},
                                                    {"--max-error", "0.1", "--quality", "draft"}}) {
      std::vector<std::string> arguments = {command, sky};
      if (command == std::string("bake")) arguments.insert(arguments.end(), {"-o", folder / "out"});
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Run run = runTool(arguments);
      INFO(command << " " << options[0] << " " << options[1] << "\n" << run.err);
      REQUIRE(run.status == 1);
      REQUIRE(run.said(options[0]));
      REQUIRE(run.out.empty());
      REQUIRE_FALSE(fs::exists(folder / "out"));
    }
}

TEST_CASE("Budget, WhatCannotBeMetSaysTheBestAndWritesNothing") {
  const Folder folder;
  fs::create_directory(folder / "out");
  const std::string sky =
      folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps + "\nbands = 2\nreconstruction = \"projected\""));
  const std::vector<std::string> said = {"max_error = 0.001", "cannot be met", "least error", "2 bands", "bytes"};
  requireCannot(folder, sky, {"--max-error", "0.001"}, said);
  bakeReport(sky, folder / "out");
  requireCannot(folder, sky, {"--max-error", "0.001"}, said);
}

TEST_CASE("Budget, ALeastErrorThatIsSaidCanBeHad") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps + "\nbands = 3"));
  const std::string words = "the least error of the irradiance is ";
  const std::string said = runBake(sky, folder / "out", {"--max-error", "0.0001"}).err;
  INFO(said);
  REQUIRE(said.find(words) != std::string::npos);
  const double least = std::strtod(said.c_str() + said.find(words) + words.size(), nullptr);
  REQUIRE(least > 0.0001);
  constexpr double kBetween = 1.02;  // between a plan's instants a certificate may find more
  const json report = bakeReport(sky, folder / "out", {"--max-error", std::to_string(kBetween * least)});
  REQUIRE(report["certificate"]["max_error"] <= kBetween * least);
  REQUIRE(report["certificate"]["max_error"] > 0.8 * least);
}

TEST_CASE("Budget, ATargetGetsTheLightThatItReads") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps));
  const std::pair<const char*, int> targets[] = {{"sh2", 2}, {"sh3", 3}, {"unity", 3}};
  for (const auto& [target, bands] : targets) {
    INFO(target);
    const json report = bakeReport(sky, folder / target, {"--max-error", "0.5", "--target", target});
    REQUIRE(report["target"] == target);
    REQUIRE(report["certificate"]["max_error"] <= 0.5);
    const json info = printedJson({"inspect", folder / target, "--json"});
    REQUIRE(info["sky"]["modes"]["count"] == 0);
    REQUIRE(info["sky"]["bands"].get<int>() <= bands);
  }
  fs::create_directory(folder / "out");
  requireCannot(
      folder, sky, {"--max-error", "0.0001", "--target", "unity"},
      {"the least error of the irradiance is", "target = \"unity\" reads no more than 3 bands", "--target modes"});
  const std::string five = folder.write("five.toml", skyText(kDay, kDaySun, kNoCubemaps + "\nbands = 5"));
  requireCannot(folder, five, {"--max-error", "0.3", "--target", "sh3"}, {"bake.bands = 5", "at most 3 bands"});
  REQUIRE(runBake(sky, folder / "out", {"--target", "lumen"}).status == 1);
}

TEST_CASE("Budget, FixedCubemapsThatAreTooCoarseWriteNothing") {
  const Folder folder;
  fs::create_directory(folder / "out");
  const std::string sky =
      folder.write("sky.toml", skyText(kDay, kDaySun, "cubemap_size = 2\ncubemap_times = 2\nmax_error = 0.1"));
  requireCannot(folder, sky, {}, {"max_error = 0.1", "2 cubemaps of 2", "rgba16f", "cubemap_size"});
}

TEST_CASE("Budget, KeepsWhatTheFileFixes") {
  const Folder folder;
  const std::string sky =
      folder.write("sky.toml", skyText(kDay, kDaySun,
                                       "max_error = 1\nbands = 3\nkeys = [0, 2, 4, 5.5, 6, 6.5, 7, 8, 9, 10, 11, 12, "
                                       "13, 14, 15, 16, 17, 18, 20, 22.25]\nencoding = \"float16\"\n"
                                       "reconstruction = \"fitted\"\ncubemap_size = 16\ncubemap_times = 24\n"
                                       "cubemap_format = \"rgba16f\"\ngradient_format = \"rgb32f\""));
  const json report = bakeReport(sky, folder / "out");
  INFO(report.dump());
  REQUIRE(report["table"]["bands"] == 3);
  REQUIRE(report["table"]["keys"] == 20);
  REQUIRE(report["table"]["encoding"] == "float16");
  REQUIRE(report["table"]["reconstruction"] == "fitted");
  REQUIRE(report["cubemaps"]["time_h"].size() == 24);
  REQUIRE(report["cubemaps"]["size"] == 16);
  REQUIRE(report["cubemaps"]["format"] == "rgba16f");
  REQUIRE(report["gradients"]["format"] == "rgb32f");
  const json keys = printedJson({"inspect", folder / "out", "--json"})["sky"]["keys"];
  REQUIRE(keys.size() == 20);
  REQUIRE(keys[19]["time_h"] == 22.25);
}

TEST_CASE("Budget, AutoIsAsIfTheKeyWereNotThere") {
  const Folder folder;
  const std::string absent = folder.write("absent.toml", skyText(kUniform, kStillSun, ""));
  const std::string automatic = folder.write(
      "auto.toml", skyText(kUniform, kStillSun,
                           "bands = \"auto\"\nkeys = \"auto\"\ncubemap_size = \"auto\"\ncubemap_times = \"auto\"\n"
                           "cubemap_format = \"auto\"\ngradient_format = \"auto\"\nreconstruction = \"auto\"\n"
                           "encoding = \"auto\""));
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--max-error", "0.1"}}) {
    json one = planOf(absent, more);
    json other = planOf(automatic, more);
    one.erase("inputs");
    other.erase("inputs");
    REQUIRE(one == other);
  }
}

TEST_CASE("Budget, PlanSaysWhatABakeMakes") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps));
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--max-error", "0.1"}}) {
    const json plan = planOf(sky, more);
    const json report = bakeReport(sky, folder / "out", more);
    REQUIRE(plan["table"] == report["table"]);
    REQUIRE(plan["left_out"] == report["left_out"]);
    REQUIRE(plan["cubemaps"]["bytes"] == report["cubemaps"]["bytes"]);
    REQUIRE(plan["gradients"]["format"] == report["gradients"]["format"]);
    std::vector<std::string> arguments = {"plan", sky, "--progress", "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::string text = runTool(arguments).out;
    INFO(text);
    REQUIRE(text.find(std::to_string(report["table"]["keys"].get<int>()) + " keys x ") != std::string::npos);
    REQUIRE(text.find(report["table"]["encoding"].get<std::string>() + ": " +
                      std::to_string(report["table"]["bytes"].get<int>()) + " bytes") != std::string::npos);
  }
}

TEST_CASE("Budget, TheQuadratureTakesAHundredthOfIt") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps));
  const auto quadrature = [&](const std::vector<std::string>& more) {
    return planOf(sky, more)["table"]["quadrature"].get<std::string>();
  };
  REQUIRE(quadrature({}).find("1e-05 of c0") != std::string::npos);
  REQUIRE(quadrature({"--max-error", "0.1"}).find("circles in 2 panels") != std::string::npos);
  REQUIRE(quadrature({"--max-error", "0.03"}).find("circles in 4 panels") != std::string::npos);
  REQUIRE(quadrature({"--max-error", "0.01"}).find("circles in 12 panels") != std::string::npos);
}

TEST_CASE("Budget, AStillSkyTakesOneKeyAndOneCubemap") {
  const Folder folder;
  const json report =
      bakeReport(folder.write("sky.toml", skyText(kDay, kStillSun, "")), folder / "out", {"--max-error", "0.1"});
  INFO(report.dump());
  REQUIRE(report["table"]["keys"] == 1);
  REQUIRE(report["cubemaps"]["time_h"].size() == 1);
  REQUIRE(report["certificate"]["parts"]["time"] <= 1e-6);
}

TEST_CASE("Budget, FittedCoefficientsNeedNone") {
  const Folder folder;
  const auto of = [&](const std::string& how) {
    const std::string sky = folder.write(
        how + ".toml", skyText(kDay, kDaySun, kNoCubemaps + "\nbands = 3\nreconstruction = \"" + how + "\""));
    return bakeReport(sky, folder / how);
  };
  const json projected = of("projected");
  const json fitted = of("fitted");
  REQUIRE(projected["table"]["keys"] == 288);
  REQUIRE(fitted["table"]["keys"] == 288);
  const auto truncation = [](const json& report) { return report["certificate"]["parts"]["truncation"].get<double>(); };
  REQUIRE(truncation(fitted) <
          0.85 * truncation(projected));  // A minimax fit lowers the error of a clear sky's 3 bands by a third.
}

TEST_CASE("Budget, ModesNeedOne") {
  const Folder folder;
  fs::create_directory(folder / "out");
  const std::string sky =
      folder.write("sky.toml", skyText(kDay, kDaySun, kNoCubemaps + "\nreconstruction = \"modes\""));
  requireCannot(folder, sky, {}, {"bake.reconstruction = \"modes\"", "max_error", "--quality"});
  const json report = bakeReport(sky, folder / "out", {"--max-error", "0.05"});
  REQUIRE(report["table"]["modes"]["count"] >= 1);
  REQUIRE(report["certificate"]["max_error"] <= 0.05);
  const std::string with_window = folder.write(
      "window.toml", skyText(kDay, kDaySun, kNoCubemaps + "\nreconstruction = \"modes\"\nwindow = \"mildest\""));
  requireCannot(folder, with_window, {"--max-error", "0.05"}, {"bake.window = 'mildest'", "off", "modes"});
}

TEST_CASE("Budget, SameBytesForAnyThreads") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kDay, kDaySun, ""));
  bakeReport(sky, folder / "one", {"--max-error", "0.1", "--threads", "1"});
  bakeReport(sky, folder / "two", {"--max-error", "0.1", "--threads", "2"});
  const auto names = filesUnder(folder / "one");
  REQUIRE(filesUnder(folder / "two") == names);
  for (const auto& name : names) {
    INFO(name);
    if (name != "timing.json")
      REQUIRE(readBytes(folder.path() / "one" / name) == readBytes(folder.path() / "two" / name));
  }
}

TEST_CASE("Budget, TheMildestWindowIsOneOfProjectedCoefficients") {
  const Folder folder;
  const auto of = [&](const std::string& window, const std::vector<std::string>& more) {
    const std::string sky = folder.write(
        "sky.toml", skyText(kDay, kDaySun, kNoCubemaps + "\nbands = 2\nkeys = 24\nwindow = \"" + window + "\""));
    return bakeReport(sky, folder / window, more);
  };
  const json mild = of("mildest", {});
  INFO(mild.dump());
  REQUIRE(mild["table"]["window_strength"] > 0.0);
  REQUIRE_FALSE(of("off", {})["table"].contains("window_strength"));
  REQUIRE(of("mildest", {"--max-error", "0.9"})["table"]["reconstruction"] == "projected");
}
