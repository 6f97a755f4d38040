// SPDX-License-Identifier: Apache-2.0
// A real file system that is full, out of names or read-only. Needs Linux, where a test may mount one that nobody else
// sees.
#include <sched.h>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <functional>
#include <iostream>

#include "level_text.h"
#include "two_bakes.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

constexpr int kRefused = 77;
constexpr std::uintmax_t kPage = 4096;

bool put(const char* path, const std::string& text) {
  std::ofstream stream(path);
  stream << text;
  stream.close();
  return !stream.fail();
}

/// Gives this process its own view of the mounted file systems. Without root's rights it does so as the same user in a
/// new namespace.
bool separateMounts() {
  const auto uid = ::geteuid();
  const auto gid = ::getegid();
  if (::unshare(CLONE_NEWNS) != 0) {
    const auto same = [](auto id) { return std::to_string(id) + " " + std::to_string(id) + " 1"; };
    if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0 || !put("/proc/self/setgroups", "deny") ||
        !put("/proc/self/uid_map", same(uid)) || !put("/proc/self/gid_map", same(gid)))
      return false;
  }
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

bool mountAt(const fs::path& place, const std::string& options, unsigned long flags = 0) {
  return ::mount("welkin_test", place.c_str(), "tmpfs", MS_NOSUID | MS_NODEV | flags, options.c_str()) == 0;
}

/// Runs the checks in a process of their own, on a small file system at `place`.
void onSmallDisk(const fs::path& place, const std::string& options, const std::function<void()>& checks) {
  std::cout.flush();
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    int status = 1;
    if (!separateMounts() || !mountAt(place, options)) ::_exit(kRefused);
    try {
      checks();
      status = 0;
    } catch (...) {  // Catch2 has already printed it.
    }
    std::cout.flush();
    ::_exit(status);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kRefused)
    WARN("skipped: the system lets this test mount no file system");
  else
    REQUIRE(status == 0);
}

void requireStatus(const TwoBakes& bakes, int status, const std::string& why = "") {
  const Run run = runTool(bakes.command("new"));
  INFO(run.err);
  REQUIRE(run.status == status);
  REQUIRE(run.said(why));
  bakes.requireWhole();
}

/// Fills the disk up to so many free bytes.
void fillBut(const fs::path& disk, std::uintmax_t bytes) {
  fs::remove(disk / "filler");
  const auto room = fs::space(disk).available;
  REQUIRE(room >= bytes);
  std::ofstream(disk / "filler") << std::string(room - bytes, '.');
  REQUIRE(fs::space(disk).available == bytes);
}

}  // namespace

TEST_CASE("SmallDisk, AnyRoomThatIsLeft") {
  const Folder folder;
  TwoBakes bakes(8, folder.path());
  onSmallDisk(folder.path(), "size=64k", [&] {
    std::uintmax_t room = 0;
    for (int status = 2; status != 0; room += kPage) {
      INFO(room << " bytes free");
      bakes.putOld();
      fillBut(folder.path(), room);
      const Run run = runTool(bakes.command("new"));
      INFO(run.err);
      status = run.status;
      REQUIRE((status == 0 || (status == 2 && run.said("No space left on device"))));
      bakes.requireWhole();
    }
    REQUIRE(room > 2 * kPage);
    bakes.requireIs("new");
  });
}

TEST_CASE("SmallDisk, TooSmallForTheNewBake") {
  const Folder folder;
  TwoBakes bakes(64, folder.path());
  onSmallDisk(folder.path(), "size=256k", [&] {
    requireStatus(bakes, 2, "No space left on device");
    REQUIRE_FALSE(fs::exists(bakes.out() / "sky.welkin"));
    REQUIRE(mountAt(folder.path(), "size=4m", MS_REMOUNT));
    requireStatus(bakes, 0);
    bakes.requireIs("new");
  });
}

TEST_CASE("SmallDisk, NoNameIsLeft") {
  const Folder folder;
  TwoBakes bakes(8, folder.path());
  onSmallDisk(folder.path(), "size=256k,nr_inodes=100", [&] {
    bakes.putOld();
    struct statvfs disk {};
    REQUIRE(::statvfs(folder.path().c_str(), &disk) == 0);
    const auto used = disk.f_files - disk.f_ffree;
    REQUIRE(mountAt(folder.path(), "nr_inodes=" + std::to_string(used), MS_REMOUNT));
    requireStatus(bakes, 2, "No space left on device");
    bakes.requireIs("old");
    REQUIRE(mountAt(folder.path(), "nr_inodes=" + std::to_string(used + 4), MS_REMOUNT));
    requireStatus(bakes, 0);
    bakes.requireIs("new");
  });
}

TEST_CASE("SmallDisk, ReadOnly") {
  const Folder folder;
  TwoBakes bakes(8, folder.path());
  onSmallDisk(folder.path(), "size=256k", [&] {
    bakes.putOld();
    REQUIRE(mountAt(folder.path(), "", MS_REMOUNT | MS_RDONLY));
    requireStatus(bakes, 2, "Read-only file system");
    REQUIRE(runTool(bakes.command("old")).status == 0);  // it is up to date
    bakes.requireIs("old");
    const Run run = runTool({"bake", bakes.file("new_level/sky.toml"), "-o", folder / "none"});
    REQUIRE(run.status == 2);
    REQUIRE(run.said(folder / "none: cannot make the folder: Read-only file system"));
    REQUIRE(mountAt(folder.path(), "", MS_REMOUNT));
    requireStatus(bakes, 0);
    bakes.requireIs("new");
  });
}

TEST_CASE("SmallDisk, ReadOnlyAndUpToDateIsNoError") {
  const Folder folder;
  const SmallLevel level;
  const auto bake = [&](const std::string& transfer) {
    level.writeLevel(transfer);
    return runTool({"bake", level / "level.toml", "-o", folder / "out", "--progress", "none", "--certify", "none"});
  };
  onSmallDisk(folder.path(), "size=1m", [&] {
    REQUIRE(bake("rays = 64").status == 0);
    std::ofstream(folder / "out/.welkin.lock") << "of a killed bake";
    REQUIRE(mountAt(folder.path(), "", MS_REMOUNT | MS_RDONLY));
    const std::string timing = readBytes(folder / "out/timing.json");
    const Run same = bake("rays = 64");
    INFO(same.err);
    REQUIRE(same.status == 0);
    REQUIRE(readBytes(folder / "out/timing.json") == timing);
    const Run other = bake("rays = 128");
    INFO(other.err);
    REQUIRE(other.status == 2);
    REQUIRE(other.said("Read-only file system"));
    REQUIRE(runTool({"validate", folder / "out"}).status == 0);
  });
}
