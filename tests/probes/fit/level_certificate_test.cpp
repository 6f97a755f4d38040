// SPDX-License-Identifier: Apache-2.0
// The certificate of a level beside errors that are known.
#include "probes/certify/level_certificate.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fit_level.h"

namespace welkin::tests {
namespace {

const certify::CertifySettings kSettings{64, 32, 256, 2, false};

std::vector<sectors::SectorFile> bakedAll(const geometry::Surfaces& surfaces, const model::Sky& sky,
                                          build::Fit fit = build::Fit::surfaces) {
  const build::LevelBake level(surfaces, fitSection(fit), sky, std::nullopt);
  std::vector<sectors::SectorFile> files;
  for (const geometry::SectorId sector : level.sectors()) files.push_back(level.bake(sector, {}));
  return files;
}

}  // namespace

TEST_CASE("LevelCertificate, BakesWithDoubledLightAreOffByTheLightItself") {
  const geometry::Surfaces ground = groundOf(Number3(0.0), 90.0);  // black: the sky's light is direct
  const model::Sky sky = uniformSky(1.0);
  const std::vector<sectors::SectorFile> files = bakedAll(ground, sky, build::Fit::none);
  const geometry::Tracer tracer(ground);
  const certify::LevelCertificate good = certify::certifyLevel(tracer, sky, files, kSettings);
  CHECK(good.surface_points >= 64);
  CHECK(good.surface.total.rms < 0.01);  // open ground under an even sky is linear in the normal
  CHECK(good.surface.nothing.rms == Approx(1.0).margin(0.01));
  CHECK(good.surface.without == 0.0);
  // Probes of half the visibility have half the light, as on black ground nothing bounces.
  const certify::LevelCertificate bad = [&] {
    const model::Sky brighter = uniformSky(2.0);
    std::vector<sectors::SectorFile> half = files;
    for (sectors::SectorFile& file : half)
      for (std::uint16_t& v : file.probes.visibility) v = static_cast<std::uint16_t>(v / 2);
    return certify::certifyLevel(tracer, brighter, half, kSettings);
  }();
  CHECK(bad.surface.total.rms == Approx(0.5).margin(0.01));
  CHECK(bad.surface.sky.rms == bad.surface.total.rms);
  CHECK(bad.surface.sky.nothing == Approx(1.0).margin(0.01));
  CHECK_FALSE(bad.surface.sky.worse);
  CHECK(bad.surface.sun_bounce.rms == 0.0);
  CHECK_FALSE(bad.surface.sun_bounce.worse);  // there is none, and none is given
  REQUIRE_FALSE(bad.worst.empty());
  CHECK(bad.worst[0].error < -0.45);
}

TEST_CASE("LevelCertificate, LightThatIsNotThereIsWorseThanNothing") {
  const model::Sky sky = uniformSky(1.0);
  geometry::Surfaces level = groundOf(Number3(0.0), 90.0);
  const std::vector<sectors::SectorFile> files = bakedAll(level, sky, build::Fit::none);
  // A closed hall that the bake has not seen leaves no light.
  addBoxInside(level, {-90.0, -0.5, -90.0}, {90.0, 8.0, 90.0}, addMaterial(level, Number3(0.0)));
  const geometry::Tracer tracer(level);
  const certify::PartError air = certify::certifyLevel(tracer, sky, files, kSettings).air.sky;
  CHECK(air.rms > 0.3);
  CHECK(air.nothing == 0.0);
  CHECK(air.worse);
}

TEST_CASE("LevelCertificate, WhereNoProbeServesTheErrorIsThatOfNoLight") {
  const geometry::Surfaces yard = fitYard();
  const model::Sky sky = fitSky();
  std::vector<sectors::SectorFile> files = bakedAll(yard, sky);
  const geometry::Tracer tracer(yard);
  const certify::LevelCertificate before = certify::certifyLevel(tracer, sky, files, kSettings);
  CHECK(before.surface.without < 0.05);
  CHECK(before.surface.total.rms < 0.5 * before.surface.nothing.rms);
  for (sectors::SectorFile& file : files) {
    file.grid.fill(geometry::kNoProbe);
    file.cuts = {};
  }
  const certify::LevelCertificate after = certify::certifyLevel(tracer, sky, files, kSettings);
  CHECK(after.surface.without == 1.0);
  CHECK(after.surface.total.rms == after.surface.nothing.rms);
  CHECK(after.surface.nothing.rms == Approx(before.surface.nothing.rms).margin(0.01));  // other seeds of an hour
}

TEST_CASE("LevelCertificate, ItsIntervalHoldsForMorePoints") {
  const geometry::Surfaces yard = fitYard();
  const model::Sky sky = fitSky();
  const std::vector<sectors::SectorFile> files = bakedAll(yard, sky);
  const geometry::Tracer tracer(yard);
  certify::CertifySettings some = kSettings, many = kSettings;
  some.surface_points = 512;
  many.surface_points = 4096;
  const certify::RmsError few = certify::certifyLevel(tracer, sky, files, some).surface.total;
  const certify::RmsError more = certify::certifyLevel(tracer, sky, files, many).surface.total;
  CHECK(few.interval > 0.0);
  CHECK(more.interval < 0.01);
  // Twice the interval of the difference. A few points beside the box make most of the error, and few draws miss them.
  CHECK(std::abs(few.rms - more.rms) < 2.0 * std::hypot(few.interval, more.interval));
}

}  // namespace welkin::tests
