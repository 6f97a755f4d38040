// SPDX-License-Identifier: Apache-2.0
// Opening refuses every cut, every flipped bit and every foreign file with its code, and reads nothing outside.
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <welkin/welkin.hpp>

#include "format/container.h"
#include "tests/folder.h"
#include "tests/runtime/small_file.h"

namespace welkin {
namespace {

using tests::smallFile;

/// Copies the bytes to a heap block of exactly their size, so that the sanitizer sees a read past the end.
WelkinResult openCopy(const std::vector<std::byte>& bytes) {
  const std::vector<std::byte> copy(bytes);
  alignas(16) static const std::byte kNothing[1] = {};
  WelkinSky* sky = nullptr;
  const WelkinResult result = welkin_sky_open_memory(copy.empty() ? kNothing : copy.data(), copy.size(), &sky, nullptr);
  if (result == WELKIN_OK) {
    WelkinSkySample sample;
    CHECK(welkin_sky_sample(sky, 7.0, &sample) == WELKIN_OK);
  } else {
    CHECK(sky == nullptr);
  }
  welkin_sky_close(sky);
  return result;
}

TEST_CASE("Open, AcceptsWhatWasWritten") {
  CHECK(openCopy(smallFile()) == WELKIN_OK);
}

TEST_CASE("Open, EveryCutIsRefused") {
  const auto& whole = smallFile();
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const std::vector<std::byte> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    REQUIRE(openCopy(cut) == WELKIN_ERROR_TRUNCATED);
  }
  std::vector<std::byte> longer = whole;
  longer.push_back(std::byte{0});
  CHECK(openCopy(longer) == WELKIN_ERROR_TRUNCATED);
}

TEST_CASE("Open, EveryFlippedBitIsRefused") {
  std::vector<std::byte> bytes = smallFile();
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      bytes[i] ^= std::byte(1 << bit);
      REQUIRE(openCopy(bytes) != WELKIN_OK);
      bytes[i] ^= std::byte(1 << bit);
    }
}

TEST_CASE("Open, CodesTellWhatIsWrong") {
  std::vector<std::byte> bytes = smallFile();
  bytes[0] = std::byte{'X'};
  CHECK(openCopy(bytes) == WELKIN_ERROR_FOREIGN);
  bytes = smallFile();
  bytes[8] = std::byte{99};
  CHECK(openCopy(bytes) == WELKIN_ERROR_VERSION);
  WelkinSky* sky = nullptr;
  WelkinMessage message{};
  CHECK(welkin_sky_open_memory(bytes.data(), bytes.size(), &sky, &message) == WELKIN_ERROR_VERSION);
  CHECK(message.text == std::string("format version 99; this library reads version 2: it is older than the file"));
  bytes[8] = std::byte{1};
  CHECK(welkin_sky_open_memory(bytes.data(), bytes.size(), &sky, &message) == WELKIN_ERROR_VERSION);
  CHECK(message.text == std::string("format version 1; this library reads version 2: bake again"));
  bytes = smallFile();
  bytes.back() ^= std::byte{1};
  CHECK(openCopy(bytes) == WELKIN_ERROR_CHECKSUM);
  CHECK(openCopy({}) == WELKIN_ERROR_FOREIGN);
  alignas(16) static std::byte shifted[1 << 16];
  REQUIRE(smallFile().size() + 1 < sizeof shifted);
  std::memcpy(shifted + 1, smallFile().data(), smallFile().size());
  CHECK(welkin_sky_open_memory(shifted + 1, smallFile().size(), &sky, nullptr) == WELKIN_ERROR_ARGUMENT);
}

TEST_CASE("Open, FilesAndTheirErrors") {
  Sky sky;
  CHECK(sky.open("/nonexistent/sky.welkin").code == WELKIN_ERROR_FILE);
  CHECK(sky.open("/").code == WELKIN_ERROR_FILE);
  CHECK(sky.open("/dev/null").code == WELKIN_ERROR_FILE);
  const tests::Folder folder;
  const std::string path = folder / "sky.welkin";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(smallFile().data()), std::streamsize(smallFile().size()));
  CHECK(sky.open(path));
  CHECK(sky.info().cubemap_count == 2);
  const Status status = sky.open("/nonexistent/sky.welkin");
  CHECK_THAT(status.message, Catch::Matches(tests::kMissingFile));
  CHECK(sky.info().cubemap_count == 2);  // a failed open keeps the sky that was there
}

TEST_CASE("Api, NullArgumentsAreErrors") {
  WelkinSky* sky = nullptr;
  CHECK(welkin_sky_open_file(nullptr, &sky, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sky_open_file("x", nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sky_open_memory(nullptr, 1, &sky, nullptr) == WELKIN_ERROR_ARGUMENT);
  WelkinSkySample sample;
  CHECK(welkin_sky_sample(nullptr, 0.0, &sample) == WELKIN_ERROR_ARGUMENT);
  REQUIRE(welkin_sky_open_memory(smallFile().data(), smallFile().size(), &sky, nullptr) == WELKIN_OK);
  CHECK(welkin_sky_sample(sky, 0.0, nullptr) == WELKIN_ERROR_ARGUMENT);
  WelkinCubemap cubemap;
  CHECK(welkin_sky_cubemap(sky, 2, &cubemap) == WELKIN_ERROR_ARGUMENT);
  double time = 0.0;
  CHECK(welkin_sky_key_time(sky, 2, &time) == WELKIN_ERROR_ARGUMENT);
  welkin_sky_close(sky);
  welkin_sky_close(nullptr);
}

TEST_CASE("Sample, CubemapPairAndWeight") {
  WelkinSky* sky = nullptr;
  REQUIRE(welkin_sky_open_memory(smallFile().data(), smallFile().size(), &sky, nullptr) == WELKIN_OK);
  const double expected[][4] = {
      {6.0, 0, 1, 0.0}, {9.0, 0, 1, 0.25}, {18.0, 1, 0, 0.0}, {21.0, 1, 0, 0.25}, {3.0, 1, 0, 0.75}};
  for (const auto& [time, first, second, weight] : expected) {
    WelkinSkySample s;
    REQUIRE(welkin_sky_sample(sky, time, &s) == WELKIN_OK);
    CAPTURE(time);
    CHECK(s.cubemap[0] == std::uint32_t(first));
    CHECK(s.cubemap[1] == std::uint32_t(second));
    CHECK(double{s.cubemap_weight} == Approx(weight));
  }
  welkin_sky_close(sky);
}

}  // namespace
}  // namespace welkin
