// SPDX-License-Identifier: Apache-2.0
// Probes in the runtime against the double reference (probes/sectors/level_light.h).
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>
#include <welkin/level.hpp>

#include "sky/bake/encode.h"
#include "sky/table/family_plan.h"
#include "tests/runtime/level_points.h"

namespace welkin::tests {
using transfer::SunTransfer;

TEST_CASE("Level, IrradianceIsTheReferencesAtEveryKindOfPoint") {
  // Floats of 24 bits and sums of some fifty of them.
  constexpr double kFloats = 2e-6;
  for (const auto sun : {SunTransfer::none, SunTransfer::sh, SunTransfer::directional})
    for (const bool emits : {false, true}) {
      const RandomLevel baked(3, 37, sun == SunTransfer::directional ? 10 : 0, sun, emits);
      OpenedLevel opened(baked);
      for (const double time_h : {0.25, 5.0, 7.5, 12.0, 17.0, 21.0}) {
        INFO("sun " << static_cast<int>(sun) << ", emits " << emits << ", hour " << time_h);
        CHECK(differenceOf(baked, opened, time_h) < kFloats);
      }
    }
}

TEST_CASE("Level, TheBudgetAndTheThreadsDoNotChangeTheResult") {
  const RandomLevel baked(3, 37, 10, SunTransfer::directional, true);
  OpenedLevel whole(baked), pieces(baked);
  const WelkinSkySample sample = whole.relight(9.25);
  pieces.relight(8.0);
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = light.sun_bounce = light.local = 1.0F;
  REQUIRE(welkin_level_set_light(pieces.level, &light) == WELKIN_OK);
  WelkinRelight result{};
  std::uint32_t calls = 0;
  for (result.remaining = 1; result.remaining > 0; ++calls) {
    std::uint32_t count = 0;
    REQUIRE(welkin_level_relight_begin(pieces.level, 10, &count) == WELKIN_OK);
    CHECK(count <= 10);
    for (std::uint32_t i = count; i > 0; --i) REQUIRE(welkin_level_relight_range(pieces.level, i - 1, 1) == WELKIN_OK);
    REQUIRE(welkin_level_relight_end(pieces.level, &result) == WELKIN_OK);
    CHECK(result.remaining == 3 * 37 - std::min(3U * 37U, 10 * (calls + 1)));
  }
  CHECK(calls == 12);
  for (const Point& p : somePoints(500)) {
    float a[3], b[3];
    REQUIRE(welkin_level_irradiance(whole.level, 1, &p.position, &p.normal, &a, nullptr) == WELKIN_OK);
    REQUIRE(welkin_level_irradiance(pieces.level, 1, &p.position, &p.normal, &b, nullptr) == WELKIN_OK);
    CHECK(std::memcmp(a, b, sizeof a) == 0);
  }
}

TEST_CASE("Level, TheSameLightRelightsNothing") {
  const RandomLevel baked(2, 37, 10, SunTransfer::directional, false);
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(9.25);
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = light.sun_bounce = light.local = 1.0F;
  WelkinRelight result{};
  REQUIRE(welkin_level_set_light(opened.level, &light) == WELKIN_OK);
  REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, &result) == WELKIN_OK);
  CHECK((result.relit == 0 && result.remaining == 0));
  light.sky = 0.5F;
  REQUIRE(welkin_level_set_light(opened.level, &light) == WELKIN_OK);
  REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, &result) == WELKIN_OK);
  CHECK(result.relit == 74);
}

TEST_CASE("Level, TheOrderInWhichSectorsStreamDoesNotMatter") {
  const RandomLevel baked(4, 37, 10, SunTransfer::directional, true);
  OpenedLevel a(baked), b(baked);
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const auto x = static_cast<std::int32_t>(random() % 4) - 1;
    WelkinSector* sector = nullptr;
    REQUIRE(welkin_level_remove(b.level, x, 0, &sector) == WELKIN_OK);
    REQUIRE(sector != nullptr);
    WelkinSector* none = nullptr;
    REQUIRE(welkin_level_remove(b.level, x, 0, &none) == WELKIN_OK);
    CHECK(none == nullptr);
    if (i % 3 == 0) b.relight(i * 0.1);
    REQUIRE(welkin_level_add(b.level, sector) == WELKIN_OK);
    CHECK(welkin_level_add(b.level, sector) == WELKIN_ERROR_ARGUMENT);
  }
  a.relight(15.0);
  b.relight(15.0);
  for (const Point& p : somePoints(500)) {
    float x[3], y[3];
    REQUIRE(welkin_level_irradiance(a.level, 1, &p.position, &p.normal, &x, nullptr) == WELKIN_OK);
    REQUIRE(welkin_level_irradiance(b.level, 1, &p.position, &p.normal, &y, nullptr) == WELKIN_OK);
    CHECK(std::memcmp(x, y, sizeof x) == 0);
  }
}

TEST_CASE("Level, ARelightingWithoutABudgetIsExactInTheMiddleOfAPass") {
  const RandomLevel baked(3, 37, 10, SunTransfer::directional, true);
  OpenedLevel whole(baked), between(baked);
  whole.relight(15.0);
  between.relight(9.0);
  for (const double time_h : {9.5, 9.6}) {
    const WelkinSkySample sample = between.sampleAt(time_h);
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    REQUIRE(welkin_level_set_light(between.level, &light) == WELKIN_OK);
    REQUIRE(welkin_level_relight(between.level, 50, nullptr) == WELKIN_OK);  // ends within a sector
  }
  between.relight(15.0);
  WelkinRelight result{};
  REQUIRE(welkin_level_relight(between.level, 0, &result) == WELKIN_OK);
  CHECK(result.remaining == 0);
  for (const Point& p : somePoints(500)) {
    float a[3], b[3];
    REQUIRE(welkin_level_irradiance(whole.level, 1, &p.position, &p.normal, &a, nullptr) == WELKIN_OK);
    REQUIRE(welkin_level_irradiance(between.level, 1, &p.position, &p.normal, &b, nullptr) == WELKIN_OK);
    CHECK(std::memcmp(a, b, sizeof a) == 0);
  }
}

TEST_CASE("Level, SectorsThatComeAreRelitFirst") {
  constexpr std::uint32_t kProbes = 37;
  const RandomLevel baked(6, kProbes, 10, SunTransfer::directional, true);
  OpenedLevel whole(baked), streams(baked);
  const WelkinSkySample sample = whole.relight(15.0);
  streams.relight(9.0);
  WelkinSector* away[2] = {};
  for (int i = 0; i < 2; ++i) REQUIRE(welkin_level_remove(streams.level, 1 + 2 * i, 0, &away[i]) == WELKIN_OK);
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = light.sun_bounce = light.local = 1.0F;
  REQUIRE(welkin_level_set_light(streams.level, &light) == WELKIN_OK);
  WelkinRelight result{};
  REQUIRE(welkin_level_relight(streams.level, kProbes / 2, &result) == WELKIN_OK);  // a pass is under way
  for (WelkinSector* sector : away) REQUIRE(welkin_level_add(streams.level, sector) == WELKIN_OK);
  const auto isRight = [&](std::int32_t x, bool wanted) {
    const float position[1][3] = {{64.0F * static_cast<float>(x) + 30.0F, 20.0F, 30.0F}};
    WelkinColours a[1], b[1];
    REQUIRE(welkin_level_colours(whole.level, 1, position, a, nullptr) == WELKIN_OK);
    REQUIRE(welkin_level_colours(streams.level, 1, position, b, nullptr) == WELKIN_OK);
    INFO("sector " << x);
    CHECK((std::memcmp(a, b, sizeof a) == 0) == wanted);
  };
  REQUIRE(welkin_level_relight(streams.level, kProbes, &result) == WELKIN_OK);
  REQUIRE(welkin_level_relight(streams.level, kProbes, &result) == WELKIN_OK);
  CHECK(result.remaining == 4 * kProbes - kProbes / 2);
  for (const std::int32_t x : {1, 3}) isRight(x, true);
  for (const std::int32_t x : {0, 2, 4}) isRight(x, false);
  REQUIRE(welkin_level_relight(streams.level, UINT32_MAX, &result) == WELKIN_OK);
  CHECK((result.relit == 4 * kProbes - kProbes / 2 && result.remaining == 0));
  for (std::int32_t x = -1; x < 5; ++x) isRight(x, true);
}

TEST_CASE("Level, ColoursGiveTheIrradianceOfEveryNormal") {
  const RandomLevel baked(2, 37, 10, SunTransfer::directional, false);
  OpenedLevel opened(baked);
  opened.relight(10.0);
  for (const Point& p : somePoints(300)) {
    WelkinColours colours;
    std::uint8_t served = 0;
    REQUIRE(welkin_level_colours(opened.level, 1, &p.position, &colours, &served) == WELKIN_OK);
    float rgb[3], sh[4][3];
    REQUIRE(welkin_colours_irradiance(&colours, p.normal, rgb) == WELKIN_OK);
    REQUIRE(welkin_colours_sh(&colours, sh) == WELKIN_OK);
    const f64::ShBasis basis = f64::shBasis({double{p.normal[0]}, double{p.normal[1]}, double{p.normal[2]}});
    for (int c = 0; c < 3; ++c) {
      double e = 0.0;
      for (int k = 0; k < 4; ++k) e += f64::cosineLobe(k == 0 ? 0 : 1) * double{sh[k][c]} * basis.v[k];
      CHECK(double{rgb[c]} == Approx(std::max(e, 0.0)).margin(1e-5));
    }
    // The same light at a surface whose push ends there.
    float position[3];
    for (int c = 0; c < 3; ++c) position[c] = p.position[c] - p.normal[c];
    float pushed[3];
    REQUIRE(welkin_level_irradiance(opened.level, 1, &position, &p.normal, &pushed, nullptr) == WELKIN_OK);
    for (int c = 0; c < 3; ++c) CHECK(double{pushed[c]} == Approx(double{rgb[c]}).margin(1e-3));
  }
}

/// The colours at many points of a level lit by a sample.
std::vector<double> lightOfAll(OpenedLevel& opened, const WelkinSkySample& sample) {
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = light.sun_bounce = light.local = 1.0F;
  REQUIRE(welkin_level_set_light(opened.level, &light) == WELKIN_OK);
  REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, nullptr) == WELKIN_OK);
  std::vector<double> numbers;
  for (const Point& p : somePoints(200)) {
    WelkinColours colours;
    REQUIRE(welkin_level_colours(opened.level, 1, &p.position, &colours, nullptr) == WELKIN_OK);
    for (const auto& rgb : colours.irradiance)
      numbers.insert(numbers.end(), {double{rgb[0]}, double{rgb[1]}, double{rgb[2]}});
  }
  return numbers;
}

/// Requires that a relight by the blend is the blend of both relights. Returns the blend.
WelkinSkySample requireFollows(OpenedLevel& opened, const WelkinSkySample& clear, const WelkinSkySample& storm) {
  WelkinSkySample blended{};
  REQUIRE(welkin_sample_blend(&clear, &storm, 0.3F, &blended) == WELKIN_OK);
  const auto first = lightOfAll(opened, clear), second = lightOfAll(opened, storm), mixed = lightOfAll(opened, blended);
  double largest = 0.0, worst = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    largest = std::max(largest, std::abs(first[i]));
    apart = std::max(apart, std::abs(mixed[i] - first[i]));
    worst = std::max(worst, std::abs(mixed[i] - (0.7 * first[i] + 0.3 * second[i])));
  }
  CHECK(largest > 0.0);
  CHECK(apart > 0.1 * largest);
  CHECK(worst < 1e-5 * largest);  // floats
  return blended;
}

TEST_CASE("Level, ProbesFollowABlendOfSkies") {
  const RandomLevel baked(2, 37, 10, SunTransfer::directional, false);
  OpenedLevel opened(baked);
  const WelkinSkySample clear = opened.sampleAt(9.0);
  WelkinSkySample storm = clear;  // darker and bluer, with hardly a sun
  for (auto& coefficient : storm.ambient_sh)
    for (int c = 0; c < 3; ++c) coefficient[c] *= 0.2F + 0.1F * static_cast<float>(c);
  for (int c = 0; c < 3; ++c) {
    storm.ambient_ground[c] *= 0.2F + 0.1F * static_cast<float>(c);
    storm.sun.normal_irradiance[c] *= 0.05F;
  }
  storm.sun.illuminance *= 0.05F;
  requireFollows(opened, clear, storm);
}

TEST_CASE("Level, ProbesFollowABlendOfAFamily") {
  bake::SkyFile files[] = {skyOfLevel(), skyOfLevel()};
  model::Sky& storm = files[1].sky;
  storm.luminance = *model::findLuminance("cie-2");
  storm.intensity = base::Curve::constant(0.3);
  storm.sun.illuminance = base::Curve::constant(0.2);
  std::vector<double> hours;
  for (int i = 0; i < 24; ++i) hours.push_back(i);
  const table::ErrorGrid grid;
  std::vector<table::DayFields> fields;
  std::vector<table::DayValues> values;
  for (const bake::SkyFile& file : files)
    fields.push_back(table::sampleDay(file.sky, hours, table::brightestOf(file.sky), {}));
  for (const table::DayFields& day : fields) values.emplace_back(day, grid);
  std::vector<table::FamilyMember> family = {{&values[0], {}}, {&values[1], {}}};
  for (table::FamilyMember& member : family) {
    member.request.max_error = 0.05;
    member.request.reconstruction = table::Reconstruction::modes;
  }
  const auto plan = table::planFamily(family);
  RandomLevel baked(2, 37, 10, SunTransfer::directional, false);
  baked.sky = bake::encodeSky(files[0], plan[0].table, {}, plan[0].encoding);
  OpenedLevel opened(baked);
  const AlignedBytes bytes(bake::encodeSky(files[1], plan[1].table, {}, plan[1].encoding));
  Sky second;
  REQUIRE(second.open(bytes.data(), bytes.size));
  WelkinSkySample of_second{};
  REQUIRE(second.sample(9.0, of_second));
  const WelkinSkySample blended = requireFollows(opened, opened.sampleAt(9.0), of_second);
  CHECK(blended.mode_count == static_cast<std::uint32_t>(plan[0].table.modes->count));
  // The sectors fit every sky of the family that has the level's paths and ground.
  WelkinOpenInfo info{};
  const AlignedBytes index(sectors::encodeLevel(baked.index));
  info.data = index.data();
  info.size = index.size;
  WelkinLevel* level = nullptr;
  CHECK(welkin_level_open(&info, second.get(), nullptr, &level, nullptr) == WELKIN_OK);
  welkin_level_close(level);
}

TEST_CASE("Level, FilesOfDifferentBakesAreRefused") {
  const RandomLevel baked(2, 37, 10, SunTransfer::directional, false);
  OpenedLevel opened(baked);
  const auto refused = [&](const RandomLevel& other, const char* why) {
    const AlignedBytes index(sectors::encodeLevel(other.index));
    WelkinOpenInfo info{};
    info.data = index.data();
    info.size = index.size;
    WelkinLevel* level = nullptr;
    WelkinMessage message{};
    CHECK(welkin_level_open(&info, opened.sky, nullptr, &level, &message) == WELKIN_ERROR_CONTENT);
    CHECK(level == nullptr);
    CHECK_THAT(message.text, Catch::Contains(why));
  };
  RandomLevel other = baked;
  other.index.sun_path->declination_rad += 1e-9;
  refused(other, "path than that of the sky's sun");
  other = baked;
  other.index.moon_path.reset();
  refused(other, "moon");
  other = baked;
  other.index.ground_albedo[1] = 0.25;
  refused(other, "albedo 0.3 0.25 0.1");
  const RandomLevel another(2, 37, 10, SunTransfer::directional, false, 2);
  const AlignedBytes sector(another.sectorBytes(1));
  WelkinSector* of_another = nullptr;
  WelkinMessage message{};
  CHECK(welkin_sector_open(opened.level, sector.data(), sector.size, &of_another, &message) == WELKIN_ERROR_CONTENT);
  CHECK(of_another == nullptr);
  CHECK_THAT(message.text, Catch::Contains("different bakes"));
  const AlignedBytes sky(baked.sky);
  CHECK(welkin_sector_open(opened.level, sky.data(), sky.size, &of_another, &message) == WELKIN_ERROR_KIND);
  CHECK_THAT(message.text, Catch::Contains("sector_X_Z"));
}

TEST_CASE("Level, TheFarthestSectorLeavesFirst") {
  const RandomLevel baked(4, 8, 0, SunTransfer::none, false);
  OpenedLevel opened(baked);
  const float left[3] = {-40, 0, 30}, right[3] = {150, 0, 30}, middle[3] = {64, 0, 32};
  std::int32_t x = 9, z = 9;
  REQUIRE(welkin_level_farthest(opened.level, left, &x, &z) == WELKIN_OK);
  CHECK((x == 2 && z == 0));
  REQUIRE(welkin_level_farthest(opened.level, right, &x, &z) == WELKIN_OK);
  CHECK((x == -1 && z == 0));
  REQUIRE(welkin_level_farthest(opened.level, middle, &x, &z) == WELKIN_OK);
  CHECK((x == -1 && z == 0));  // as far as the sector 2: the first one
  const float beside[3] = {60, 0, 32};
  REQUIRE(welkin_level_farthest(opened.level, beside, &x, &z) == WELKIN_OK);
  CHECK((x == 2 && z == 0));  // its middle is at 160 m, that of the first sector at -32 m
}

}  // namespace welkin::tests
