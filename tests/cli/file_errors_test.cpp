// SPDX-License-Identifier: Apache-2.0
// Files and folders that the system refuses: status 2, and a message that names the right one.
#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <string>
#include <thread>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

void requireRefused(const std::vector<std::string>& arguments, const std::string& said) {
  const Run run = runTool(arguments, {{}, "", "", 0, 30.0});
  INFO(arguments[0] << " " << arguments[1] << "\n" << run.err);
  REQUIRE(run.status == 2);
  REQUIRE(run.said(said));
}

/// Tries every command that reads a sky file.
void requireSkyRefused(const Folder& folder, const std::string& sky, const std::string& said) {
  requireRefused({"bake", sky, "-o", folder / "unused"}, said);
  requireRefused({"plan", sky}, said);
  requireRefused({"eval", sky, "--time", "1", "--direction", "0,1,0"}, said);
  REQUIRE_FALSE(fs::exists(folder / "unused"));
}

/// Tries every command that reads a baked file.
void requireBakedRefused(const std::string& path, const std::string& said) {
  requireRefused({"inspect", path}, said);
  requireRefused({"validate", path}, said);
  requireRefused({"sample", path, "--time", "1"}, said);
  requireRefused({"render", path, "--time", "1", "-o", "unused.png"}, said);
}

}  // namespace

TEST_CASE("Files, MissingOnesAreNamed") {
  const Folder folder;
  requireSkyRefused(folder, folder / "none.toml", folder / "none.toml: cannot read: No such file");
  requireBakedRefused(folder / "none.welkin", folder / "none.welkin");
  folder.write("sky.toml", skyText(kUniform + "\ngradient_sun = \"none.png\""));
  requireSkyRefused(folder, folder / "sky.toml", "sky.toml:4: sky.gradient_sun = 'none.png': " + (folder / "none.png"));
  folder.write("sky.toml", skyText(kUniform + "\npolarising_tint = \"none.exr\""));
  requireSkyRefused(folder, folder / "sky.toml", folder / "none.exr");
}

TEST_CASE("Files, NamesCannotSteerTheTerminal") {
  const Folder folder;
  const std::string name = "a\x1b[31m\nb\xff\u202e.toml";
  for (const Run& run : {runTool({"plan", folder / name}), runTool({"inspect", folder / name}), runTool({name})}) {
    INFO(run.err);
    REQUIRE(run.status != 0);
    REQUIRE(run.said("a\\x1b[31m\\nb\\xff\\u202e.toml"));
    REQUIRE(run.err.find('\n') == run.err.size() - 1);
  }
}

TEST_CASE("Files, AnyNameOfAPictureBakes") {
  const Folder folder;
  folder.write("\U0001f305.ppm", "P3 1 1 255 9 90 200\n");
  const std::string sky = folder.write("sky.toml", skyText("gradient_sun = \"\U0001f305.ppm\""));
  const Run run = runTool({"bake", sky, "-o", folder / "out", "--certify", "none"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  REQUIRE(runTool({"inspect", "--json", folder / "out"}).out.find("\U0001f305.ppm") != std::string::npos);
}

TEST_CASE("Files, FoldersAreNotFiles") {
  const Folder folder;
  fs::create_directory(folder / "empty");
  requireSkyRefused(folder, folder / "empty", "Is a directory");
  requireBakedRefused(folder / "empty", folder / "empty");
  folder.write("sky.toml", skyText(kUniform + "\ngradient_anti = \"empty\""));
  requireSkyRefused(folder, folder / "sky.toml", folder / "empty");
  fs::create_directories(folder / "nested/sky.welkin");
  requireBakedRefused(folder / "nested", "sky.welkin");
}

TEST_CASE("Files, PipesAreRefusedWithoutWaiting") {
  const Folder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  requireSkyRefused(folder, folder / "pipe", folder / "pipe");
  requireBakedRefused(folder / "pipe", folder / "pipe");
  folder.write("sky.toml", skyText(kUniform + "\ngradient_sun = \"pipe\""));
  requireSkyRefused(folder, folder / "sky.toml", folder / "pipe");
}

TEST_CASE("Files, UnreadableOnesAreNamed") {
  if (::geteuid() == 0) return;  // root reads everything
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  REQUIRE(::chmod(sky.c_str(), 0) == 0);
  requireSkyRefused(folder, sky, "Permission denied");
  requireBakedRefused(sky, "Permission denied");
}

TEST_CASE("Files, OutputsThatCannotBeMadeAreNamed") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, "keys = 2\ncubemap_size = 2"));
  const std::string wall = folder.write("wall", "in the way");
  requireRefused({"bake", sky, "-o", wall}, wall);
  requireRefused({"bake", sky, "-o", wall + "/deeper"}, wall);
  requireRefused({"bake", sky, "-o", "/proc/welkin"}, "/proc/welkin");
  requireRefused({"bake", sky, "-o", ""}, "cannot make the folder");
  requireRefused({"init", wall}, wall);
  requireRefused({"bake", sky, "-o", folder / "out", "--report", folder / "no/report.json"}, "no/report.json");
  requireRefused({"bake", sky, "-o", folder / "out", "--depfile", wall + "/d"}, wall);
  folder.write("a/cubemaps", "in the way");
  requireRefused({"bake", sky, "-o", folder / "a"}, folder / "a/cubemaps");
  fs::create_directories(folder / "b/sky.welkin");
  requireRefused({"bake", sky, "-o", folder / "b"}, folder / "b/sky.welkin");
  REQUIRE(readBytes(wall) == "in the way");
  for (const auto& name : filesUnder(folder.path())) REQUIRE_FALSE(name.ends_with(".tmp"));
}

TEST_CASE("FileErrors, GeometryThatChangesWhileItIsReadIsToBeReadAgain") {
  const Folder folder;
  folder.write("sky.toml", skyText(kUniform, kStillSun));
  const std::string level = folder.write("level.toml", "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"a.obj\"\n");
  std::string text = "v 0 0 0\nv 0 0 9\nv 9 0 0\n";
  for (int i = 0; i < 400'000; ++i) text += "f 1 2 3\n";  // some tenths of a second to read
  const std::string file = folder.write("a.obj", text);
  const std::string other = folder.write("b.obj", "v 0 0 0\nv 0 0 9\nv 9 0 0\nf 1 2 3\n");
  const int watch = inotify_init1(IN_CLOEXEC);
  REQUIRE(watch >= 0);
  REQUIRE(inotify_add_watch(watch, file.c_str(), IN_CLOSE_NOWRITE) >= 0);
  bool swapped = false;
  std::thread swap([&] {
    pollfd closed{watch, POLLIN, 0};
    if (::poll(&closed, 1, 20'000) != 1) return;  // ms; the first reading has ended
    fs::rename(other, file);
    swapped = true;
  });
  const Run run = runTool({"plan", level, "--progress", "none"}, {{}, "", "", 0, 30.0});
  swap.join();
  ::close(watch);
  INFO(run.err);
  REQUIRE(swapped);
  REQUIRE(run.status == 2);
  REQUIRE(run.said("a.obj: changed while it was read; bake again"));
  REQUIRE(runTool({"plan", level, "--progress", "none"}).status == 0);
}
