// SPDX-License-Identifier: Apache-2.0
// Baked files that are cut, damaged, foreign or of another version: status 3 from every command that reads them.
// tests/runtime covers every byte; these tests show that the statuses reach the shell.
#include <catch2/catch.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;

namespace {

std::string bakedBytes() {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, "keys = 2\ncubemap_size = 2"));
  REQUIRE(runTool({"bake", sky, "-o", folder / "out", "--progress", "none"}).status == 0);
  return readBytes(folder / "out/sky.welkin");
}

void requireInvalid(const std::string& bytes, const std::string& said) {
  const Folder folder;
  const std::string file = folder.write("sky.welkin", bytes);
  const Run run = runTool({"validate", file}, {{}, "", "", 0, 30.0});
  INFO(bytes.size() << " bytes: " << run.err);
  REQUIRE(run.status == 3);
  REQUIRE(run.out.empty());
  REQUIRE(run.said(file));
  REQUIRE(run.said(said));
}

}  // namespace

TEST_CASE("WelkinErrors, CutFiles") {
  const std::string whole = bakedBytes();
  requireInvalid("", "not a .welkin file");
  for (const std::size_t size : {std::size_t{1}, std::size_t{8}, std::size_t{63}})
    requireInvalid(whole.substr(0, size), "64");
  for (const std::size_t size : {std::size_t{64}, std::size_t{65}, whole.size() / 2, whole.size() - 1})
    requireInvalid(whole.substr(0, size), std::to_string(whole.size()));
  requireInvalid(whole + '\0', std::to_string(whole.size()));
}

TEST_CASE("WelkinErrors, DamagedFiles") {
  const std::string whole = bakedBytes();
  const auto flipped = [&](std::size_t at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x40);
    return bytes;
  };
  requireInvalid(flipped(0), "not a .welkin file");
  requireInvalid(flipped(8), "version");
  requireInvalid(flipped(12), "header");
  requireInvalid(flipped(32), "kind");
  requireInvalid(flipped(16), "bytes");
  requireInvalid(flipped(24), "checksum");
  requireInvalid(flipped(40), "checksum");
  for (int i = 0; i < 8; ++i)
    requireInvalid(flipped(64 + (whole.size() - 65) * static_cast<std::size_t>(i) / 7), "checksum");
}

TEST_CASE("WelkinErrors, ForeignFilesByEveryCommand") {
  const Folder folder;
  const std::string file = folder.write("sky.welkin", "\x89PNG\r\n\x1a\n and so on, a picture and not a sky");
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"inspect", file},
                                             {"inspect", file, "--json"},
                                             {"validate", file},
                                             {"validate", folder.path().string()},
                                             {"sample", file, "--time", "1"},
                                             {"sample", folder.path().string(), "--time", "1"},
                                             {"render", file, "--time", "1", "-o", folder / "a.png"}}) {
    const Run run = runTool(arguments);
    INFO(arguments[0] << run.err);
    REQUIRE(run.status == 3);
    REQUIRE(run.said(file));
    REQUIRE(run.said("not a .welkin file"));
  }
  REQUIRE_FALSE(std::filesystem::exists(folder / "a.png"));
}
