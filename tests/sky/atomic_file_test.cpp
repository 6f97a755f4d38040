// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all, beside other writers, leftovers and planted links.
#include "sky/base/atomic_file.h"

#include <catch2/catch.hpp>
#include <thread>

#include "sky/base/descriptor.h"
#include "sky/base/error.h"
#include "tests/folder.h"

using namespace welkin;
using welkin::tests::filesUnder;
using welkin::tests::Folder;
using welkin::tests::readBytes;
namespace fs = std::filesystem;

TEST_CASE("AtomicFile, ALeftoverOfADeadProcessGoes") {
  const Folder folder;
  folder.write("a.tmp", "half");
  base::writeFile(folder / "a", "whole");
  REQUIRE(filesUnder(folder.path()) == std::vector<std::string>{"a"});
  folder.write("a.tmp", "half");
  base::writeFile(folder / "a", "whole");  // the same bytes: the file stays, the leftover goes
  REQUIRE(filesUnder(folder.path()) == std::vector<std::string>{"a"});
  REQUIRE(readBytes(folder / "a") == "whole");
}

TEST_CASE("AtomicFile, ATemporaryFileOfALiveProcessStays") {
  const Folder folder;
  const base::Descriptor other(::open(folder.write("a.tmp", "of another").c_str(), O_RDWR | O_CLOEXEC));
  REQUIRE(base::lockRange(other, {}) == base::Locked::yes);
  for (const char* bytes : {"first", "second", "second"}) {
    base::writeFile(folder / "a", bytes);
    REQUIRE(readBytes(folder / "a") == bytes);
    REQUIRE(readBytes(folder / "a.tmp") == "of another");
  }
  REQUIRE(filesUnder(folder.path()) == std::vector<std::string>{"a", "a.tmp"});
}

TEST_CASE("AtomicFile, APlantedLinkIsNotFollowed") {
  const Folder folder;
  folder.write("victim", "precious");
  for (const char* target : {"victim", "new"}) {
    fs::create_symlink(folder / target, folder / "a.tmp");
    base::writeFile(folder / "a", target);
    REQUIRE(readBytes(folder / "a") == target);
    REQUIRE(filesUnder(folder.path()) == std::vector<std::string>{"a", "victim"});
    REQUIRE_FALSE(fs::is_symlink(folder / "a"));
  }
  REQUIRE(readBytes(folder / "victim") == "precious");
}

TEST_CASE("AtomicFile, WritersOfOneFileLeaveOneWholeFile") {
  constexpr int kWriters = 4;
  constexpr int kTimes = 50;
  const Folder folder;
  const auto bytesOf = [](int writer) { return std::string(10000 + 1000 * writer, static_cast<char>('a' + writer)); };
  const auto isWhole = [&](const std::string& bytes) {
    for (int i = 0; i < kWriters; ++i)
      if (bytes == bytesOf(i)) return true;
    return false;
  };
  base::writeFile(folder / "a", bytesOf(0));
  std::vector<std::thread> writers;
  std::vector<int> failed(kWriters);
  for (int i = 0; i < kWriters; ++i)
    writers.emplace_back([&, i] {
      for (int k = 0; k < kTimes; ++k) try {
          base::writeFile(folder / "a", bytesOf((i + k) % kWriters));
        } catch (const base::Error&) {
          ++failed[static_cast<std::size_t>(i)];
        }
    });
  bool whole = true;
  for (int k = 0; k < kTimes; ++k) whole = whole && isWhole(readBytes(folder / "a"));
  for (std::thread& writer : writers) writer.join();
  REQUIRE(whole);
  REQUIRE(isWhole(readBytes(folder / "a")));
  REQUIRE(failed == std::vector<int>(kWriters));
  REQUIRE(filesUnder(folder.path()) == std::vector<std::string>{"a"});
}

TEST_CASE("AtomicFile, AFileThatHasGoneSinceIsNamed") {
  const Folder folder;
  base::writeFile(folder / "a", "whole");
  base::requireSize(folder / "a", 5);
  for (const auto& [name, bytes] : {std::pair("a", 4), {"none", 5}}) try {
      base::requireSize(folder / name, static_cast<std::uint64_t>(bytes));
      FAIL(name);
    } catch (const base::Error& e) {
      REQUIRE(e.status() == base::ExitStatus::file);
      REQUIRE(std::string(e.what()).starts_with(folder / name));
    }
}
