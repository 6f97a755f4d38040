// SPDX-License-Identifier: Apache-2.0
// The rules that every function of the C interface keeps: sizes of structs, unit vectors, reasons of refusals, the
// game's memory and log, kinds of files.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <welkin/welkin.hpp>

#include "format/container.h"
#include "tests/folder.h"
#include "tests/runtime/check_sizes.h"
#include "tests/runtime/heap.h"
#include "tests/runtime/small_file.h"

namespace welkin {
namespace {

using tests::checkSizes;
using tests::Heap;
using tests::smallFile;

Sky opened() {
  Sky sky;
  REQUIRE(sky.open(smallFile().data(), smallFile().size()));
  return sky;
}

WelkinSkySample sampled(const Sky& sky, double time_h) {
  WelkinSkySample sample{};
  REQUIRE(sky.sample(time_h, sample));
  return sample;
}

TEST_CASE("Api, StructsKeepToTheirSize") {
  const Sky sky = opened();
  const auto call = [&](auto* function) { return [&sky, function](auto* out) { return function(sky.get(), out); }; };
  checkSizes<WelkinSkyInfo>(52, call(welkin_sky_info));
  checkSizes<WelkinLuminance>(32, call(welkin_sky_luminance));
  checkSizes<WelkinGradients>(48, call(welkin_sky_gradients));
  checkSizes<WelkinStars>(48, call(welkin_sky_stars));
  checkSizes<WelkinModes>(24, call(welkin_sky_modes));
  checkSizes<WelkinCertificate>(144, call(welkin_sky_certificate));
  checkSizes<WelkinCubemap>(40, [&](WelkinCubemap* out) { return welkin_sky_cubemap(sky.get(), 1, out); });
  checkSizes<WelkinSkySample>(936, [&](WelkinSkySample* out) { return welkin_sky_sample(sky.get(), 7.0, out); });
  const WelkinSkySample a = sampled(sky, 7.0);
  const WelkinSkySample b = sampled(sky, 9.0);
  checkSizes<WelkinSkySample>(936, [&](WelkinSkySample* out) { return welkin_sample_blend(&a, &b, 0.5F, out); });
}

TEST_CASE("Api, ASampleOfAnotherSizeIsRefusedAsInput") {
  const Sky sky = opened();
  WelkinSkySample sample = sampled(sky, 7.0);
  sample.struct_size = 936 - 4;  // below that of the first release
  float rgb[3] = {-1.0F, -1.0F, -1.0F};
  const float up[3] = {0.0F, 1.0F, 0.0F};
  WelkinLight light{};
  WelkinFilamentIrradianceOverPi filament{};
  WelkinUnityIrradianceOverPi unity{};
  CHECK(welkin_sky_irradiance(sky.get(), &sample, up, rgb) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sample_irradiance(&sample, up, rgb) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_dome_radiance(sky.get(), &sample, up, rgb) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_disc_radiance(&sample, up, 0.0F, rgb) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_star_radiance(sky.get(), &sample, up, rgb) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sample_key_light(&sample, &light) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_filament(&sample, &filament) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_unity(&sample, &unity) == WELKIN_ERROR_ARGUMENT);
  CHECK(rgb[0] == -1.0F);
}

TEST_CASE("Api, VectorsAreUnitVectors") {
  const Sky sky = opened();
  const WelkinSkySample sample = sampled(sky, 7.0);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const struct {
    float v[3];
    bool holds;
  } cases[] = {{{0, 1, 0}, true},        {{0.6F, 0, -0.8F}, true},  {{0, 0.9991F, 0}, true},
               {{0, -1.0009F, 0}, true}, {{0, 0.9989F, 0}, false},  {{0, 1.0011F, 0}, false},
               {{0, 2, 0}, false},       {{0, 0, 0}, false},        {{nan, 1, 0}, false},
               {{0, 1, nan}, false},     {{0, infinity, 0}, false}, {{1e30F, 1e30F, 0}, false}};
  for (const auto& [v, holds] : cases) {
    CAPTURE(v[0], v[1], v[2]);
    const WelkinResult expected = holds ? WELKIN_OK : WELKIN_ERROR_ARGUMENT;
    float rgb[3] = {-1.0F, -1.0F, -1.0F};
    CHECK(welkin_sky_irradiance(sky.get(), &sample, v, rgb) == expected);
    CHECK(welkin_sample_irradiance(&sample, v, rgb) == expected);
    CHECK(welkin_dome_radiance(sky.get(), &sample, v, rgb) == expected);
    CHECK(welkin_disc_radiance(&sample, v, 0.0F, rgb) == expected);
    CHECK(welkin_star_radiance(sky.get(), &sample, v, rgb) == expected);
    CHECK((rgb[0] == -1.0F) == !holds);
  }
}

TEST_CASE("Api, RefusalsNameTheArgument") {
  Sky sky = opened();
  WelkinSkySample sample{};
  const Status status = sky.sample(std::nan(""), sample);
  CHECK(status.message == "welkin_sky_sample: time_h is nan, must be finite");
  CHECK(welkin_sky_sample(nullptr, 0.0, &sample) == WELKIN_ERROR_ARGUMENT);
  CHECK(std::string(welkin_argument_error()) == "welkin_sky_sample: sky is null");
  WelkinCubemap cubemap{};
  CHECK(sky.cubemap(2, cubemap).message == "welkin_sky_cubemap: index is 2, the sky has 2 cubemaps");
  double hour = 0.0;
  CHECK(sky.keyTime(9, hour).message == "welkin_sky_key_time: index is 9, the sky has 2 keys");
  const WelkinSkySample good = sampled(sky, 3.0);
  CHECK(blend(good, good, 1.5F, sample).message == "welkin_sample_blend: weight is 1.5, must be 0 to 1");
  WelkinSkySample bad = good;
  bad.mode_count = 13;
  Float3 rgb{};
  CHECK(sky.irradiance(bad, {0, 1, 0}, rgb).message ==
        "welkin_sky_irradiance: sample->mode_count is 13, must be 0 to 12");
  bad = good;
  bad.time_h = 24.0;
  CHECK(sky.domeRadiance(bad, {0, 1, 0}, rgb).message ==
        "welkin_dome_radiance: sample->time_h is 24, must be in [0, 24)");
  CHECK(sky.sample(1.0, sample).message.empty());  // a success has none
}

TEST_CASE("Api, VersionIsTheHeaders") {
  CHECK(version() == WELKIN_VERSION);
  CHECK(formatVersion() == format::kSkyVersion);
  STATIC_REQUIRE(WELKIN_VERSION == (WELKIN_VERSION_MAJOR << 20 | WELKIN_VERSION_MINOR << 10 | WELKIN_VERSION_PATCH));
}

TEST_CASE("FileKind, ComesFromTheHeader") {
  std::vector<std::byte> bytes = smallFile();
  CHECK(fileKind(bytes.data(), bytes.size()) == WELKIN_FILE_SKY);
  CHECK(fileKind(bytes.data(), 64) == WELKIN_FILE_SKY);
  CHECK(fileKind(bytes.data(), 63) == WELKIN_FILE_FOREIGN);
  CHECK(fileKind(nullptr, 64) == WELKIN_FILE_FOREIGN);
  const auto payload = std::as_bytes(std::span(bytes)).subspan(64);
  const std::span flatbuffer(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size());
  const std::pair<format::Kind, WelkinFileKind> kinds[] = {{format::Kind::sector, WELKIN_FILE_SECTOR},
                                                           {format::Kind::level, WELKIN_FILE_LEVEL}};
  for (const auto& [kind, expected] : kinds) {
    const std::vector<std::byte> sealed = format::seal(flatbuffer, kind);
    CHECK(fileKind(sealed.data(), sealed.size()) == expected);
    Sky sky;
    const Status status = sky.open(sealed.data(), sealed.size());
    CHECK(status.code == WELKIN_ERROR_KIND);
    CHECK(status.message == std::string("this is ") + format::nameOf(kind) + "; a sky is needed (sky.welkin)");
  }
  bytes[32] = std::byte{3};
  CHECK(fileKind(bytes.data(), bytes.size()) == WELKIN_FILE_FOREIGN);
  bytes[0] = std::byte{0};
  CHECK(fileKind(bytes.data(), bytes.size()) == WELKIN_FILE_FOREIGN);
}

TEST_CASE("Open, MessagesTellPathAndHeader") {
  const tests::Folder folder;
  const std::string path = folder / "sky.welkin";
  std::vector<std::byte> bytes = smallFile();
  bytes[12] = std::byte{65};
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  Sky sky;
  const Status status = sky.open(path);
  CHECK(status.code == WELKIN_ERROR_CONTENT);
  CHECK(status.message == path + ": damaged: its header states a size of 65 bytes, must be 64");
  const std::string missing = sky.open(folder / "none").message;
  CHECK_THAT(missing, Catch::StartsWith((folder / "none") + ": ") && Catch::Matches(tests::kMissingFile));
}

TEST_CASE("Open, TakesTheGamesMemory") {
  for (std::size_t most = 0;; ++most) {
    Heap heap;
    heap.most = most;
    const WelkinAllocator allocator = heap.allocator();
    WelkinOpenInfo info{};
    info.flags = WELKIN_OPEN_COPY;
    info.data = smallFile().data();
    info.size = smallFile().size();
    info.allocator = &allocator;
    Sky sky;
    const Status status = sky.open(info);
    CAPTURE(most, status.message);
    if (status) {
      CHECK(heap.allocations >= 3);  // the copy, the hours of the cubemaps, the sky
      sampled(sky, 7.0);
      sky.close();
      CHECK(heap.held.empty());
      break;
    }
    CHECK(status.code == WELKIN_ERROR_MEMORY);
    CHECK(heap.held.empty());
  }
}

TEST_CASE("Open, ACopyOutlivesItsBytes") {
  const tests::Folder folder;
  const std::string path = folder / "sky.welkin";
  const auto write = [&](std::span<const std::byte> bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  };
  write(smallFile());
  Sky mapped = opened();
  WelkinOpenInfo info{};
  info.flags = WELKIN_OPEN_COPY;
  info.path = path.c_str();
  Sky sky;
  REQUIRE(sky.open(info));
  write({});  // overwritten in place: a mapping would end the program
  const WelkinSkySample expected = sampled(mapped, 7.0);
  const WelkinSkySample sample = sampled(sky, 7.0);
  CHECK(std::memcmp(&sample, &expected, sizeof sample) == 0);

  std::vector<std::byte> shifted(smallFile().size() + 1);
  std::copy(smallFile().begin(), smallFile().end(), shifted.begin() + 1);
  info.path = nullptr;
  info.data = shifted.data() + 1;
  info.size = smallFile().size();
  CHECK(sky.open(info));  // a copy is aligned whatever the caller's bytes are
}

TEST_CASE("Open, WritesToTheLog") {
  struct Lines {
    std::vector<std::pair<WelkinLogLevel, std::string>> line;
  } lines;
  WelkinLog log{};
  log.user = &lines;
  log.write = [](void* user, WelkinLogLevel level, const char* text) {
    static_cast<Lines*>(user)->line.emplace_back(level, text);
  };
  WelkinOpenInfo info{};
  info.log = &log;
  info.data = smallFile().data();
  info.size = smallFile().size();
  Sky sky;
  REQUIRE(sky.open(info));
  info.size -= 1;
  const Status status = sky.open(info);
  REQUIRE(lines.line.size() == 2);
  CHECK(lines.line[0].first == WELKIN_LOG_WARNING);
  CHECK_THAT(lines.line[0].second, Catch::Contains("was not measured"));
  CHECK(lines.line[1] == std::pair(WELKIN_LOG_ERROR, status.message));
}

TEST_CASE("Open, RefusesOptionsThatContradict") {
  Sky sky;
  WelkinOpenInfo info{};
  CHECK(sky.open(info).message == "welkin_sky_open: path and data are null");
  info.path = "sky.welkin";
  info.data = smallFile().data();
  CHECK(sky.open(info).message == "welkin_sky_open: info has both path and data");
  info.data = nullptr;
  info.flags = 2;
  CHECK(sky.open(info).message == "welkin_sky_open: info->flags is 2, must be 0 or 1");
  info.flags = 0;
  const WelkinAllocator none{};
  info.allocator = &none;
  CHECK(sky.open(info).message == "welkin_sky_open: info->allocator->allocate is null");
  info.allocator = nullptr;
  const WelkinLog silent{};
  info.log = &silent;
  CHECK(sky.open(info).message == "welkin_sky_open: info->log->write is null");
}

TEST_CASE("Constants, AreTheSamples") {
  const Sky sky = opened();
  const WelkinSkySample sample = sampled(sky, 7.5);
  WelkinSkyConstants block{};
  REQUIRE(sky.constants(sample, block));
  CHECK(block.sun.y == sample.sun.direction[1]);
  CHECK(block.sun.w == 7.5F);
  CHECK(block.moon.w == static_cast<float>(sample.coefficient_count));
  CHECK(block.ambient_sh[3].z == sample.ambient_sh[3][2]);
  CHECK(block.luminance_ek.z == sample.luminance_norm);
  WelkinLight key{};
  REQUIRE(keyLight(sample, key));
  CHECK(block.key_irradiance.x == key.normal_irradiance[0]);

  WelkinSkySample other = sample;
  other.ambient_sh[3][2] += 1.0F;
  WelkinSkyConstants weather = block;
  REQUIRE(ambientConstants(other, weather));
  CHECK(weather.ambient_sh[3].z == other.ambient_sh[3][2]);
  weather.ambient_sh[3].z = block.ambient_sh[3].z;
  CHECK(std::memcmp(&weather.sun, &block.sun, 13 * sizeof(WelkinFloat4)) == 0);  // all but the ambient light

  for (const std::size_t size : {std::size_t{0}, sizeof block - 16, sizeof block - 4, sizeof block + 16}) {
    CAPTURE(size);
    CHECK(welkin_sky_constants(sky.get(), &sample, &block, size) == WELKIN_ERROR_ARGUMENT);
  }
  CHECK(welkin_sky_constants(sky.get(), &sample, nullptr, sizeof block) == WELKIN_ERROR_ARGUMENT);
}

}  // namespace
}  // namespace welkin
