// SPDX-License-Identifier: Apache-2.0
// One writer a folder, or one a part.
#include "sky/base/folder_lock.h"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "sky/base/error.h"
#include "tests/folder.h"

using namespace welkin;
using welkin::tests::filesUnder;
using welkin::tests::Folder;
using welkin::tests::readBytes;
namespace fs = std::filesystem;

namespace {

/// The refusal of a lock or a reader; empty if there is none.
template <typename Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const base::Error& e) {
    REQUIRE(e.status() == base::ExitStatus::file);
    return e.what();
  }
  return "";
}

std::string refusal(const Folder& folder, std::optional<int> part = std::nullopt) {
  return refusal([&] { const base::FolderLock lock(folder.path(), part); });
}

std::string inUse(const Folder& folder) {
  return folder.path().string() + ": in use by process " + std::to_string(::getpid()) + " on ";
}

}  // namespace

TEST_CASE("FolderLock, OneOwnerAtATime") {
  const Folder folder;
  for (int turn = 0; turn < 2; ++turn) {
    const base::FolderLock lock(folder.path());
    REQUIRE_FALSE(lock.readOnly());
    REQUIRE(refusal(folder).starts_with(inUse(folder)));
    REQUIRE(refusal(folder, 7).starts_with(inUse(folder)));
    REQUIRE(refusal([&] { base::requireUnused(folder.path()); }).starts_with(inUse(folder)));
  }
  REQUIRE(refusal([&] { base::requireUnused(folder.path()); }).empty());
  REQUIRE(filesUnder(folder.path()).empty());
}

TEST_CASE("FolderLock, PartsHaveOwnersOfTheirOwn") {
  const Folder folder;
  {
    const base::FolderLock first(folder.path(), 0);
    const base::FolderLock last(folder.path(), 999999);
    REQUIRE(refusal(folder, 0).starts_with(inUse(folder)));
    REQUIRE(refusal(folder, 1).empty());
    REQUIRE(refusal(folder, 999998).empty());
    REQUIRE(refusal(folder, 999999).starts_with(inUse(folder)));
    REQUIRE(refusal(folder).starts_with(inUse(folder)));
    REQUIRE(refusal([&] { base::requireUnused(folder.path()); }).starts_with(inUse(folder)));
  }
  REQUIRE(refusal([&] { base::requireUnused(folder.path()); }).empty());
  REQUIRE(refusal(folder).empty());
  REQUIRE(filesUnder(folder.path()).empty());
}

TEST_CASE("FolderLock, EndsWithItsProcess") {
  const Folder folder;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const base::FolderLock lock(folder.path());
    ::_exit(0);  // without its destructor
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(filesUnder(folder.path()) == std::vector<std::string>{".welkin.lock"});
  REQUIRE(refusal([&] { base::requireUnused(folder.path()); }).empty());
  REQUIRE(refusal(folder).empty());
  REQUIRE(filesUnder(folder.path()).empty());
}

TEST_CASE("FolderLock, WritesIntoNoOtherFile") {
  const Folder folder;
  const std::string victim = folder.write("victim", "precious");
  const std::string path = folder / "out/.welkin.lock";
  fs::create_directories(folder / "out");
  for (const bool symbolic : {true, false}) {
    symbolic ? fs::create_symlink(victim, path) : fs::create_hard_link(victim, path);
    REQUIRE(refusal([&] { const base::FolderLock lock(folder / "out"); }).starts_with(path + ": cannot lock: "));
    REQUIRE(readBytes(victim) == "precious");
    fs::remove(path);
  }
  REQUIRE(refusal([&] { const base::FolderLock lock(folder / "none"); }) ==
          folder / "none: cannot lock: No such file or directory");
}

TEST_CASE("FolderLock, NamesNoControlCharacter") {
  const Folder folder;
  const base::FolderLock lock(folder.path());
  std::ofstream(folder / ".welkin.lock", std::ios::in | std::ios::out) << "\x1b[2Jred\n\xff" << std::string(57, '\0');
  REQUIRE(refusal(folder) == folder.path().string() + ": in use by [2Jred; try again when it has ended");
}
