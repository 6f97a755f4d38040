// SPDX-License-Identifier: Apache-2.0
// Small stacks and little memory: no input and no limit ends in a crash, and a refused thread or memory is status 2.
#include <OpenImageIO/imageio.h>
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "baked.h"

using namespace welkin::tests;

namespace {

/// Runs the tool under a limit of the shell's `ulimit`. A signal shows as 128 and its number.
Run runUnder(const std::string& limit, const std::vector<std::string>& arguments) {
  const Folder folder;
  std::string command = "ulimit " + limit + " && timeout 60 '" WELKIN_TOOL "'";
  for (const std::string& word : arguments) command += " '" + word + "'";
  command += " >'" + (folder / "out") + "' 2>'" + (folder / "err") + "'";
  const int status = std::system(command.c_str());
  Run run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = readBytes(folder / "out");
  run.err = readBytes(folder / "err");
  return run;
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

const std::string kSmallStack = "-s 256";  // KiB

}  // namespace

TEST_CASE("Limits, DeepTomlIsRefusedOnASmallStack") {
  const Folder folder;
  struct Nesting {
    std::string open, close;
  };
  for (const Nesting& n :
       {Nesting{"[", "]"}, Nesting{"{a=", "}"}, Nesting{"[{a=", "}]"}, Nesting{"{a.b.c.d.e.f.g.h=", "}"}})
    for (const int depth : {3, 16, 17, 200, 20000}) {
      INFO(n.open << " x " << depth);
      const std::string value = repeated(n.open, depth) + "1" + repeated(n.close, depth);
      const std::string sky = folder.write("sky.toml", "[sky]\nluminance = " + value + "\n");
      const Run run = runUnder(kSmallStack, {"plan", sky});
      REQUIRE(run.status == 3);
      const bool too_deep = depth * (n.open == "[{a=" ? 2 : 1) > 16;
      REQUIRE(run.said("sky.toml:2: more than 16 lists or tables within each other") == too_deep);
    }
  const std::string sky = folder.write("sky.toml", "[sky]\n" + repeated("a.", 20000) + "a = 1\n");
  REQUIRE(runUnder(kSmallStack, {"plan", sky}).said("sky.toml:2: a key has more than 16 parts"));
  folder.write("sky.toml", "# " + repeated("[", 50) + "\n" + skyText(kUniform) + "# {{{{{{{{{{{{{{{{{{{{\n");
  REQUIRE(runUnder(kSmallStack, {"plan", sky}).status == 0);
}

TEST_CASE("Limits, DeepJsonIsNoRecordOnASmallStack") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  const std::string out = folder / "out";
  REQUIRE(runBake(sky, out).status == 0);
  const std::string record = readBytes(out + "/sky.json");
  const std::string report = readBytes(out + "/report.json");
  for (const int depth : {10, 63, 500, 100000})
    for (const char* brackets : {"[]", "{}"}) {
      INFO(brackets << " x " << depth);
      const std::string open = brackets[0] == '[' ? "[" : "{\"a\":";
      const std::string nested = repeated(open, depth) + "1" + repeated(std::string(1, brackets[1]), depth);
      std::string text = record;
      text.replace(text.find("\"made\": ") + 8, 0, nested + ", \"other\": ");
      folder.write("out/sky.json", text);
      const Run plan = runUnder(kSmallStack, {"plan", sky, "-o", out});
      REQUIRE(plan.status == 0);
      REQUIRE(plan.out.find("unreadable: sky.json") != std::string::npos);
      REQUIRE(runUnder(kSmallStack, {"validate", out}).status == 3);
      folder.write("out/sky.json", record);
      folder.write("out/report.json", nested);
      REQUIRE(runUnder(kSmallStack, {"validate", out}).status == 3);
      folder.write("out/report.json", report);
    }
  REQUIRE(runUnder(kSmallStack, {"validate", out}).status == 0);
  folder.write("out/sky.json", repeated("[", 100000));
  REQUIRE(runUnder(kSmallStack, {"bake", sky, "-o", out, "--progress", "none"}).status == 0);
  REQUIRE(readBytes(out + "/sky.json") == record);
}

TEST_CASE("Limits, LittleMemoryForPicturesIsStatus2") {
  const Folder folder;
  const std::string picture = folder / "p.tif";  // read by OpenImageIO, whose libraries need the memory
  const auto output = OIIO::ImageOutput::create(picture);
  const std::uint8_t rgb[] = {1, 2, 3, 4, 5, 6};
  REQUIRE((output && output->open(picture, OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::UINT8))));
  REQUIRE((output->write_image(OIIO::TypeDesc::UINT8, rgb) && output->close()));
  int refused = 0;
  for (int mb = 120; mb <= 600; mb += 20) {
    const Run run = runUnder("-v " + std::to_string(mb * 1000), {"project", picture, "--bands", "1"});
    INFO(mb << " MB: " << run.status << " " << run.err);
    REQUIRE((run.status == 0 || (run.status == 2 && run.said("out of memory"))));
    refused += run.said("out of memory: reading images takes");  // else the libraries fitted, and their threads did not
  }
  REQUIRE(refused >= 10);
  REQUIRE(runUnder("-v 2000000", {"project", picture, "--bands", "1"}).status == 0);
}
