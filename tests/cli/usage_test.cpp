// SPDX-License-Identifier: Apache-2.0
// Wrong command lines: status 1, nothing on stdout, and a message with the wrong word.
#include <catch2/catch.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;

namespace {

struct Misuse {
  std::vector<std::string> arguments;
  std::string said;
};

void requireUsage(const std::vector<Misuse>& cases) {
  for (const Misuse& c : cases) {
    std::string line;
    for (const auto& word : c.arguments) line += word + " ";
    const Run run = runTool(c.arguments);
    INFO("welkin " << line << "\n" << run.err);
    REQUIRE(run.status == 1);
    REQUIRE(run.out.empty());
    REQUIRE(run.said("welkin: "));
    REQUIRE(run.said(c.said));
  }
}

}  // namespace

TEST_CASE("Usage, UnknownAndMissingWords") {
  requireUsage({{{}, "subcommand"},
                {{"cook"}, "cook"},
                {{"bake"}, "FILE"},
                {{"bake", "sky.toml"}, "-o"},
                {{"bake", "sky.toml", "-o"}, "-o"},
                {{"bake", "sky.toml", "-o", "out", "--fast"}, "--fast"},
                {{"merge", "out", "another"}, "another"},
                {{"bake", "sky.toml", "-o", "out", "--threads", "-1"}, "--threads"},
                {{"bake", "sky.toml", "-o", "out", "--threads", "many"}, "many"},
                {{"bake", "sky.toml", "-o", "out", "--progress", "loud"}, "loud"},
                {{"init"}, "DIR"},
                {{"plan"}, "FILE"},
                {{"inspect"}, "FILE"},
                {{"validate"}, "PATH"},
                {{"eval", "sky.toml", "--time", "1"}, "--direction"},
                {{"eval", "sky.toml", "--direction", "0,1,0"}, "--time"},
                {{"eval", "sky.toml", "--time", "1", "--direction", "0,1,0", "--quantity", "taste"}, "taste"},
                {{"sample", "out"}, "--time"},
                {{"render", "out", "--time", "1"}, "-o"},
                {{"render", "out", "-o", "a.png"}, "--time"}});
}

TEST_CASE("Usage, TimesMustBeFiniteNumbers") {
  for (const char* time : {"nan", "-nan", "inf", "-inf", "infinity", "abc", "", "12h", "1,5", "1e999", "0x10", "+-6"})
    requireUsage({{{"eval", "sky.toml", "--direction", "0,1,0", "--time", time}, "--time"}});
  requireUsage({{{"sample", "out", "--time=nan"}, "--time"}, {{"sample", "out", "--time", "-inf"}, "--time"}});
}

TEST_CASE("Usage, DirectionsMustBeThreeFiniteNumbersNotAllZero") {
  for (const char* direction : {"0,0,0", "-0,0,0", "1,2", "1,2,3,4", "nan,0,0", "0,inf,0", "1,,2", "", ",,", "a,b,c",
                                "1 2 3", "1,2,3 ", "1e999,0,0"})
    requireUsage({{{"eval", "sky.toml", "--time", "1", "--direction", direction}, "--direction"}});
  requireUsage({{{"sample", "out", "--time", "1", "--normal", "0,0,0"}, "--normal"},
                {{"sample", "out", "--time", "1", "--normal", "-1,0"}, "--normal"}});
}

TEST_CASE("Usage, PicturesHaveASizeAndAView") {
  for (const auto& [option, value] : {std::pair("--size", "0x5"),
                                      {"--size", "5"},
                                      {"--fov", "nan"},
                                      {"--fov", "180"},
                                      {"--yaw", "inf"},
                                      {"--pitch", "91"},
                                      {"--exposure", "dark"},
                                      {"--exposure", "nan"},
                                      {"--view", "back"},
                                      {"--sky", "blue"},
                                      {"--time", "nan"}}) {
    const Folder folder;
    const std::string words = std::string(option) + "=" + value;
    const Run run = runTool({"render", folder / "none", "-o", folder / "a.png", "--time=1", words});
    INFO(words << "\n" << run.err);
    REQUIRE(run.status == 1);
    REQUIRE(run.said(option));
  }
}

TEST_CASE("Usage, APictureIsAPng") {
  const Folder folder;
  for (const char* name : {"a.jpg", "a", ".png", "a.png/"}) {
    const Run run = runTool({"render", folder / "none", "-o", folder / name, "--time=1"});
    INFO(name << "\n" << run.err);
    REQUIRE(run.status == 1);
    REQUIRE(run.said(folder / name));
    REQUIRE(run.said(".png"));
  }
}

TEST_CASE("Usage, SignedAndExtremeDirectionsParse") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  for (const char* direction : {"-1,0,0", "-.5,0,1", "-1e-300,1e-300,0", "1e300,1e300,-1e300", "+1,+2,+3"})
    for (const auto& words :
         std::vector<std::vector<std::string>>{{"--direction", direction}, {std::string("--direction=") + direction}}) {
      std::vector<std::string> arguments = {"eval", sky, "--quantity", "luminance", "--time", "-6.5"};
      arguments.insert(arguments.end(), words.begin(), words.end());
      const Run run = runTool(arguments);
      INFO(direction << run.err);
      REQUIRE(run.status == 0);
      REQUIRE(run.out == "1 1 1\n");
    }
}

TEST_CASE("Usage, HelpAndVersionAreResults") {
  REQUIRE(runTool({"--version"}).out.find('.') != std::string::npos);
  for (const char* command :
       {"init", "bake", "plan", "inspect", "validate", "eval", "sample", "export", "study", "render"}) {
    const Run run = runTool({command, "--help"});
    REQUIRE(run.status == 0);
    REQUIRE(run.err.empty());
    REQUIRE(run.out.size() > 50);
  }
  REQUIRE(runTool({"--help"}).out.find("130 interrupted") != std::string::npos);
}
