// SPDX-License-Identifier: Apache-2.0
// Light of lamps and spots on the probes, against the double reference (probes/transfer/local_relight.h).
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <welkin/level.hpp>

#include "tests/runtime/local_level.h"

namespace welkin::tests {
namespace {

using f64::Number3;
using LampList = std::vector<WelkinPointLight>;

// Sums of up to some sixty floats of 24 bits.
constexpr double kLocalFloats = 4e-6;

const transfer::SeeEachOther kAll = [](const Number3&, const Number3&) { return true; };

RandomLevel localLevel(int sectors, std::size_t lights = 40, std::size_t transfers = 60, bool emits = false) {
  RandomLevel baked(sectors, 37, 0, transfer::SunTransfer::none, emits);
  baked.addLocal(lights, transfers);
  return baked;
}

/// Largest difference of a probe's channel from the reference, over the largest channel.
double differenceFrom(const ReferenceLight& reference, const RandomLevel& baked, const OpenedLevel& opened) {
  double worst = 0.0;
  for (std::size_t s = 0; s < baked.sector.size(); ++s)
    for (std::size_t p = 0; p < reference.sector[s].size(); ++p) {
      const WelkinColours found = lightOfProbe(baked, opened, s, p);
      for (std::size_t b = 0; b < 4; ++b)
        for (int c = 0; c < 3; ++c)
          worst = std::max(worst, std::abs(double{found.irradiance[b][c]} - reference.sector[s][p][b][c]));
    }
  CHECK(reference.largest > 0.0);
  return worst / reference.largest;
}

bool areSame(const std::vector<WelkinColours>& a, const std::vector<WelkinColours>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(WelkinColours)) == 0;
}

/// Lamps and spots of many kinds about three sectors.
LampList manyLights(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  LampList lights;
  while (lights.size() < count) {
    const Number3 v(in(-1, 1), in(-1, 1), in(-1, 1));
    if (dot(v, v) > 1.0 || dot(v, v) < 0.01) continue;
    const Number3 at(in(-80, 150), in(-5, 20), in(-20, 84));
    const Number3 colour(in(0, 3), in(0, 3), in(0, 3));
    const double outer = in(0.2, 3.1);
    lights.push_back(lights.size() % 2 == 0
                         ? lampAt(at, colour)
                         : spotAt(at, colour, v * (1.0 / std::sqrt(dot(v, v))), in(0.0, 0.8) * outer, outer));
  }
  return lights;
}

/// A wall along x = 20.3 that blocks sight, which counts its tests and where they ended.
struct WallAndCount {
  std::size_t tests = 0;
  float last_to[3] = {};
};
int seesPastWall(void* user, const float from[3], const float to[3]) {
  auto& count = *static_cast<WallAndCount*>(user);
  ++count.tests;
  std::copy_n(to, 3, count.last_to);
  return (from[0] < 20.3F) == (to[0] < 20.3F) ? 1 : 0;
}
const transfer::SeeEachOther kPastWall = [](const Number3& a, const Number3& b) {
  return (a.x < double{20.3F}) == (b.x < double{20.3F});
};

}  // namespace

TEST_CASE("LocalLights, IrradianceIsTheReferences") {
  for (const bool walled : {false, true}) {
    const RandomLevel baked = localLevel(3);
    OpenedLevel opened(baked);
    WallAndCount wall;
    for (const unsigned seed : {1U, 2U, 3U}) {
      LampList lights = manyLights(60, seed);
      lights.push_back(lampAt({0, 2, 900}, {1, 1, 1}));
      lights.push_back(spotAt({3, -70, 30}, {1, 1, 1}, {0, 1, 0}, 0.1, 0.2));
      const WelkinLightsResult result = setLamps(opened, lights, walled ? seesPastWall : nullptr, &wall);
      const ReferenceLight reference = referenceLight(baked, lights, walled ? kPastWall : kAll);
      INFO("walled " << walled << ", seed " << seed);
      CHECK(differenceFrom(reference, baked, opened) < kLocalFloats);
      CHECK(result.unseen == reference.unseen);
      CHECK(result.unseen >= 2);
      CHECK(result.unseen < 20);
      CHECK(result.shared == (seed == 1 ? 62 : 60));  // the last two stay
    }
    CHECK((wall.tests > 0) == walled);
  }
}

TEST_CASE("LocalLights, EachSingleLightIsTheReferences") {
  // A lattice is symmetric: many virtual lights are equally far. The lamps are at a light, near one, between two, in
  // the middle of four, and a little off that.
  RandomLevel baked = localLevel(2, 25, 50);
  for (std::size_t s = 0; s < 2; ++s) {
    auto& position = baked.sector[s].local->encoded.position;
    const Number3 corner = geometry::cornerOf(baked.sector[s].id);
    for (std::size_t l = 0; l < 50; ++l) {  // the lists of both sectors have all of the lights, in the same order
      position[3 * l] = static_cast<float>(-32.0 + 4.0 * static_cast<double>(l % 10) - corner.x);
      position[3 * l + 1] = 1.0F;
      position[3 * l + 2] = static_cast<float>(20.0 + 4.0 * static_cast<double>(l / 10) - corner.z);
    }
  }
  baked.reindex();
  OpenedLevel opened(baked);
  const Number3 white(1, 1, 1), red(3, 0, 0), axis(0.6, 0, 0.8);
  const LampList each = {lampAt({-24, 1, 28}, white),
                         lampAt({-24 + 1e-6, 1, 28}, red),
                         lampAt({-24.01, 1.02, 28}, white),
                         lampAt({-22, 1, 28}, white),
                         lampAt({-22, 1, 30}, white),
                         lampAt({-22.1, 2.3, 30.4}, red),
                         lampAt({-4, 4, 24}, white),
                         lampAt({40, 1, 24}, white),
                         spotAt({-24, 1, 28}, red, axis, 0.3, 0.5),
                         spotAt({-22, 1, 30}, white, axis, 0.0, 0.7),
                         spotAt({-22, 3, 30}, white, {0, -1, 0}, 0.0, 0.05),
                         spotAt({-22, 3, 30}, white, axis, 1.0, 3.0)};
  for (std::size_t i = 0; i < each.size(); ++i) {
    INFO("light " << i);
    const LampList one = {each[i]};
    CHECK(setLamps(opened, one).unseen == 0);
    CHECK(differenceFrom(referenceLight(baked, one, kAll), baked, opened) < kLocalFloats);
  }
}

TEST_CASE("LocalLights, AConeOfTheWholeSphereIsTheLamp") {
  const RandomLevel baked = localLevel(2);
  OpenedLevel opened(baked);
  const Number3 at(11, 2, 30), colour(1, 2, 3);
  setLamps(opened, {lampAt(at, colour)});
  const auto lamp = lightOfProbes(baked, opened);
  setLamps(opened, {spotAt(at, colour, {0, 0.6, -0.8}, 3.14159265, 3.14159265)});
  const auto spot = lightOfProbes(baked, opened);
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < lamp.size(); ++i)
    for (std::size_t b = 0; b < 4; ++b)
      for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, std::abs(double{lamp[i].irradiance[b][c]}));
        worst = std::max(worst, std::abs(double{lamp[i].irradiance[b][c] - spot[i].irradiance[b][c]}));
      }
  CHECK(largest > 0.0);
  CHECK(worst <= kLocalFloats * largest);
}

TEST_CASE("LocalLights, ASpotLightsTheSideThatItShinesAt") {
  // Two virtual lights, of which each lights one probe.
  RandomLevel baked(1, 2, 0, transfer::SunTransfer::none, false);
  baked.addLocal(2, 0);
  auto& local = baked.sector[0].local->encoded;
  local.position = {10, 1, 20, 20, 1, 20};
  local.count = {1, 1};
  local.light = {0, 1};
  local.scale = {0x3f80, 0x3f80};
  local.radiance.assign(24, 0);
  for (const std::size_t i : {0U, 1U, 2U, 12U, 13U, 14U}) local.radiance[i] = 127;
  baked.reindex();
  OpenedLevel opened(baked);
  const Number3 middle = geometry::cornerOf(baked.sector[0].id) + Number3(15, 1, 20), white(1, 1, 1);
  const auto both = [&](const WelkinPointLight& light) {
    setLamps(opened, {light});
    return std::array{double{lightOfProbe(baked, opened, 0, 0).irradiance[0][0]},
                      double{lightOfProbe(baked, opened, 0, 1).irradiance[0][0]}};
  };
  const auto lamp = both(lampAt(middle, white));
  CHECK(lamp[0] == Approx(lamp[1]));
  const auto right = both(spotAt(middle, white, {1, 0, 0}, 0.5, 0.8));
  CHECK(right[1] == Approx(17.0 * right[0]));  // 1 + 1 / 16 to 1 / 16
  // The power within a narrow cone of a sharp edge: (1 - cos) / 2 of the lamp's.
  const auto sharp = both(spotAt(middle, white, {0, 0, 1}, 0.5, 0.5));
  CHECK(sharp[0] + sharp[1] == Approx((lamp[0] + lamp[1]) * (1.0 - std::cos(0.5)) / 2.0).epsilon(0.01));
  CHECK(sharp[0] == Approx(sharp[1]));  // it shines at neither
  // Turning is smooth.
  double worst = 0.0, before = -1.0, most = 0.0;
  for (int i = 0; i <= 3142; ++i) {
    const double angle = i * 1e-3;
    const auto now = both(spotAt(middle, white, {std::cos(angle), 0, std::sin(angle)}, 0.3, 0.6));
    if (before >= 0.0) worst = std::max(worst, std::abs(now[1] - before));
    before = now[1];
    most = std::max(most, now[1]);
  }
  CHECK(worst < 0.02 * most);  // for a thousandth of a radian
  CHECK(worst > 0.0);
}

TEST_CASE("LocalLights, OnlyWhatALightReachesIsLitAnew") {
  const RandomLevel baked = localLevel(6);
  OpenedLevel opened(baked);
  WallAndCount wall;
  LampList lights = {lampAt({-40, 2, 30}, {1, 1, 1}), lampAt({280, 2, 30}, {1, 1, 1})};
  setLamps(opened, lights, seesPastWall, &wall);
  const auto begin = lightOfProbes(baked, opened);
  const std::size_t tests = wall.tests;
  CHECK(tests > 0);
  const WelkinLightsResult same = setLamps(opened, lights, seesPastWall, &wall);
  CHECK((same.shared == 0 && same.sectors == 0 && same.probes == 0 && same.unseen == 0));
  CHECK(wall.tests == tests);
  lights[1].position[1] = 3.0F;
  WelkinLightsResult result{};
  REQUIRE(welkin_level_set_lights(opened.level, 2, lights.data(), seesPastWall, &wall, &result) == WELKIN_OK);
  CHECK(result.shared == 1);
  CHECK(wall.tests > tests);
  CHECK(wall.last_to[0] == 280.0F);
  CHECK((result.sectors >= 1 && result.sectors <= 4));  // those beside (3, 0) and (4, 0)
  CHECK(result.probes == 37 * result.sectors);
  WelkinRelight relit{};
  REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, &relit) == WELKIN_OK);
  CHECK(relit.relit == result.probes);
  CHECK(relit.remaining == 0);
  CHECK(differenceFrom(referenceLight(baked, lights, kPastWall), baked, opened) < kLocalFloats);
  const std::size_t moved = wall.tests;
  lights[0].revision = 7;  // the same shares, but tested anew
  result = setLamps(opened, lights, seesPastWall, &wall);
  CHECK((result.shared == 1 && result.sectors == 0));
  CHECK(wall.tests > moved);
  CHECK(wall.last_to[0] == -40.0F);
  lights[1].position[1] = 2.0F;
  lights[0].revision = 0;
  setLamps(opened, lights, seesPastWall, &wall);
  CHECK(areSame(lightOfProbes(baked, opened), begin));
  const WelkinLightsResult none = setLamps(opened, {});
  CHECK((none.shared == 0 && none.sectors > 0));
  for (const WelkinColours& c : lightOfProbes(baked, opened)) CHECK(c.irradiance[3][1] == 0.0F);
}

TEST_CASE("LocalLights, AVirtualLightOfTwoSectorsCountsOnce") {
  const RandomLevel baked = localLevel(2, 40, 60);  // both lists have all eighty
  OpenedLevel opened(baked);
  WallAndCount wall;
  const LampList lights = {lampAt(virtualLightOf(baked, 0, 50) + Number3(0.01, 0, 0), {1, 2, 3})};
  setLamps(opened, lights, seesPastWall, &wall);
  const std::size_t tests = wall.tests;
  CHECK(differenceFrom(referenceLight(baked, lights, kPastWall), baked, opened) < kLocalFloats);
  for (const std::int32_t gone : {-1, 0}) {  // one list gives the shares that both gave
    WelkinSector* sector = nullptr;
    REQUIRE(welkin_level_remove(opened.level, gone, 0, &sector) == WELKIN_OK);
    wall.tests = 0;
    const WelkinLightsResult result = setLamps(opened, lights, seesPastWall, &wall);
    CHECK(result.shared == 1);
    CHECK(wall.tests == tests);
    REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
  }
}

TEST_CASE("LocalLights, TheOrderOfStreamingDoesNotMatter") {
  const RandomLevel baked = localLevel(5, 40, 60, true);
  OpenedLevel b(baked);
  WallAndCount wall;
  std::mt19937 random(3);
  for (unsigned i = 0; i < 120; ++i) {
    const LampList lights = manyLights(1 + random() % 40, i);
    std::vector<WelkinSector*> away;
    for (std::int32_t x = -1; x < 4; ++x) {
      WelkinSector* sector = nullptr;
      if (random() % 3 != 0) continue;
      REQUIRE(welkin_level_remove(b.level, x, 0, &sector) == WELKIN_OK);
      away.push_back(sector);
    }
    if (i % 2 == 0) setLamps(b, lights, seesPastWall, &wall);
    std::shuffle(away.begin(), away.end(), random);
    for (WelkinSector* sector : away) {
      REQUIRE(welkin_level_add(b.level, sector) == WELKIN_OK);
      if (random() % 4 == 0) setLamps(b, lights, seesPastWall, &wall);
    }
    setLamps(b, lights, seesPastWall, &wall);
    if (i % 10 != 0) continue;
    OpenedLevel a(baked);
    setLamps(a, lights, seesPastWall, &wall);
    INFO("turn " << i);
    REQUIRE(areSame(lightOfProbes(baked, a), lightOfProbes(baked, b)));
  }
}

TEST_CASE("LocalLights, ALightThatNeverRestsKeepsNoProbeWaiting") {
  const RandomLevel baked = localLevel(2, 40, 60, true);
  OpenedLevel opened(baked), whole(baked);
  const WelkinSkySample sample = opened.sampleAt(12.0);
  WelkinLevelLight light{};
  light.sample = &sample;
  light.local = 1.0F;
  REQUIRE(welkin_level_set_light(opened.level, &light) == WELKIN_OK);
  LampList lights = {lampAt({2, 2, 30}, {1, 1, 1})};
  WelkinRelight result{};
  for (int i = 0; i < 40; ++i) {
    lights[0].position[0] += 0.1F;
    REQUIRE(welkin_level_set_lights(opened.level, 1, lights.data(), nullptr, nullptr, nullptr) == WELKIN_OK);
    REQUIRE(welkin_level_relight(opened.level, 10, &result) == WELKIN_OK);
    CHECK(result.relit == 10);
    CHECK(result.remaining > 0);
  }
  for (const WelkinColours& c : lightOfProbes(baked, opened)) CHECK(c.irradiance[0][0] != 0.0F);  // emission at least
  REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, &result) == WELKIN_OK);
  if (result.remaining > 0) REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, &result) == WELKIN_OK);
  CHECK(result.remaining == 0);
  setLamps(whole, lights);
  CHECK(areSame(lightOfProbes(baked, opened), lightOfProbes(baked, whole)));
}

TEST_CASE("LocalLights, TheWrapperPassesTheTestOfSight") {
  const RandomLevel baked = localLevel(1);
  const AlignedBytes sky_bytes(baked.sky), index(sectors::encodeLevel(baked.index)), file(baked.sectorBytes(0));
  Sky sky;
  REQUIRE(sky.open(sky_bytes.data(), sky_bytes.size));
  WelkinOpenInfo info{};
  info.data = index.data();
  info.size = index.size;
  Level level;
  REQUIRE(level.open(info, sky));
  Sector sector;
  REQUIRE(level.openSector(file.data(), file.size, sector));
  REQUIRE(level.add(sector));
  const WelkinPointLight lamp = lampAt({-30, 2, 30}, {1, 1, 1});
  WelkinLightsResult result{};
  std::size_t tests = 0;
  const auto blind = [&tests, &lamp](const Float3& from, const Float3& to) {
    ++tests;
    return from[0] > 0.0F || to[2] != lamp.position[2];
  };
  REQUIRE(level.setLights(&lamp, 1, blind, result));
  CHECK(result.unseen == 1);
  CHECK(tests == 40);  // every light of the sector
  REQUIRE(level.setLights(
      &lamp, 1, [](const Float3&, const Float3&) { return true; }, result));
  CHECK((result.unseen == 0 && result.sectors == 1));
  REQUIRE(level.setLights(&lamp, 0, result));
  CHECK((result.shared == 0 && result.sectors == 1));
}

TEST_CASE("LocalLights, WrongLightsAreRefused") {
  const RandomLevel baked = localLevel(1);
  OpenedLevel opened(baked);
  const auto refused = [&](const WelkinPointLight& light, const char* why) {
    CHECK(welkin_level_set_lights(opened.level, 1, &light, nullptr, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
    CHECK_THAT(welkin_argument_error(), Catch::Contains(why));
  };
  const WelkinPointLight good = spotAt({0, 1, 2}, {1, 1, 1}, {0, -1, 0}, 0.2, 0.4);
  REQUIRE(welkin_level_set_lights(opened.level, 1, &good, nullptr, nullptr, nullptr) == WELKIN_OK);
  WelkinPointLight bad = good;
  bad.position[1] = std::nanf("");
  refused(bad, "position of light 0 has a coordinate nan, must be below 2^30 m");
  bad = good;
  bad.intensity[2] = -1.0F;
  refused(bad, "intensity of light 0 has a channel -1, must be 0 to 1e15");
  bad = good;
  bad.inner_rad = 0.5F;
  refused(bad, "cone of light 0 is 0.5 to 0.4");
  bad = good;
  bad.outer_rad = 3.2F;
  refused(bad, "outer <= pi");
  bad = good;
  bad.direction[1] = 0.0F;
  refused(bad, "unit vector");
  const LampList many(257, good);
  CHECK(welkin_level_set_lights(opened.level, 257, many.data(), nullptr, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK_THAT(welkin_argument_error(), Catch::Contains("count is 257, must be at most the level's 256"));
  CHECK(welkin_level_set_lights(opened.level, 1, nullptr, nullptr, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  opened.relight(12.0);
  std::uint32_t count = 0;
  const LampList moved = {lampAt({1, 2, 3}, {1, 1, 1})};
  REQUIRE(welkin_level_relight_begin(opened.level, 10, &count) == WELKIN_OK);
  REQUIRE(welkin_level_relight_end(opened.level, nullptr) == WELKIN_OK);
  opened.relight(13.0);
  REQUIRE(welkin_level_set_lights(opened.level, 1, moved.data(), nullptr, nullptr, nullptr) == WELKIN_OK);
  REQUIRE(welkin_level_relight_begin(opened.level, 10, &count) == WELKIN_OK);
  REQUIRE(count == 10);
  CHECK(welkin_level_set_lights(opened.level, 1, &good, nullptr, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK_THAT(welkin_argument_error(), Catch::Contains("a relighting has begun"));
}

}  // namespace welkin::tests
