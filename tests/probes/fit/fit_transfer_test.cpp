// SPDX-License-Identifier: Apache-2.0
// The fit of a sector's probes: its look-up beside the runtime's reference, a field that the look-up can hold, and the
// light of points that it has not seen.
#include "probes/fit/fit_transfer.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "fit_level.h"
#include "probes/fit/sky_fit.h"
#include "probes/sectors/level_light.h"
#include "probes/transfer/transfer_basis.h"

namespace welkin::tests {
namespace {

sectors::SectorFile bakedYard(build::Fit fit, placement::Walls walls = placement::Walls::cut, bool door = false) {
  build::BakeSection section = fitSection(fit);
  section.probes.walls = walls;
  if (door) {  // in the closed box's wall, 3 m in and 5 m out
    section.probes.room = {{{kBoxLow - 0.1, -0.1, kBoxLow - 0.1}, {kBoxHigh + 0.1, 4.1, kBoxHigh + 0.1}}};
    section.probes.door = {{section.probes.room[0], {{43, -1, kBoxLow - 5.0}, {49, 3, kBoxLow + 3.0}}}};
  }
  return build::LevelBake(fitYard(), section, fitSky(), std::nullopt).bake({0, 0}, {});
}

geometry::PlacedSector placedOf(const sectors::SectorFile& file) {
  geometry::PlacedSector placed;
  static_cast<geometry::SectorGrid&>(placed) = file;
  const transfer::SectorProbes probes = transfer::decodedProbes(file.probes, {0, 0});
  for (const Number3& p : probes.position) placed.probe.push_back({p});
  return placed;
}

/// Root mean square errors of luminance at points, relative to the open sky's horizontal irradiance.
struct Errors {
  double sky = 0.0, sun = 0.0;
};

Errors errorsOf(const sectors::SectorFile& file, const std::vector<fit::FitPoint>& points) {
  const geometry::Surfaces yard = fitYard();
  const geometry::Tracer tracer(yard);
  const model::Sky sky = fitSky();
  const std::vector<sectors::SectorFile> files = {file};
  const sectors::LevelLight light(files, sky, 12.0);
  const reference::DistantLight distant(sky, 12.0);
  // The ground's radiance is albedo over pi of the open sky's horizontal irradiance.
  const double open = det::kPi * distant.groundUnderSky().y / distant.groundAlbedo().y;
  Errors sum;
  std::size_t seed = 0;
  for (const fit::FitPoint& p : points) {
    const auto got = light.at(p.position, p.normal).value_or(sectors::LevelIrradiance{});
    const auto want = reference::traceReference(tracer, distant, {}, p.position, p.normal, {1024, 2, seed++});
    sum.sky += std::pow(det::luminanceOf(got.sky - want.sky.value) / open, 2);
    sum.sun += std::pow(det::luminanceOf(got.sun_bounce - want.sun_bounce.value) / open, 2);
  }
  const auto count = static_cast<double>(points.size());
  return {std::sqrt(sum.sky / count), std::sqrt(sum.sun / count)};
}

}  // namespace

TEST_CASE("FitPoints, TheyLieOnFrontsInTheSectorAndInItsAir") {
  const geometry::Surfaces yard = fitYard();
  const geometry::Tracer tracer(yard);
  const fit::FitPoints points = fit::pointsOf(tracer, {0, 0}, 2000, 500, 1);
  REQUIRE(points.surface.size() == 2000);
  REQUIRE(points.air.size() == 500);
  std::size_t level = 0;
  for (const fit::FitPoint& p : points.surface) {
    CHECK((p.position.x >= 0.0 && p.position.x < 64.0 && p.position.z >= 0.0 && p.position.z < 64.0));
    const auto on = tracer.closest(p.position + p.normal * 0.01, -p.normal, 0.02);
    CHECK((on && !on->back));
    if (p.position.y == 0.0) ++level;
  }
  // Ground without the box's walls and the other surfaces, by area: the wall has two sides, the shed one front.
  const double ground = 64.0 * 64.0 - (12.4 * 12.4 - 12.0 * 12.0);
  const double others = 12.0 * 12.0 + 4.0 * 48.0 + 12.4 * 12.4 + 4.2 * 49.6 + 5.0 * std::hypot(7.7, 3.1) + 73.0;
  CHECK(double(level) / 2000.0 == Approx(ground / (ground + others)).margin(0.05));
  Number3 mean(0.0);
  for (const fit::FitPoint& p : points.air) {
    CHECK((p.position.y >= 0.3 && p.position.y <= 7.0));
    mean += p.normal / 500.0;
  }
  CHECK(std::sqrt(dot(mean, mean)) < 4.0 / std::sqrt(500.0));  // four standard errors
  CHECK(fit::pointsOf(tracer, {0, 0}, 10, 5, 1).surface[3].position == points.surface[3].position);
  CHECK(!(fit::pointsOf(tracer, {0, 0}, 10, 5, 2).surface[3].position == points.surface[3].position));
}

TEST_CASE("FitLookUp, ItsWeightsAreTheRuntimesLookUp") {
  const bool door = GENERATE(false, true);
  const sectors::SectorFile file = bakedYard(build::Fit::none, placement::Walls::cut, door);
  REQUIRE_FALSE(file.cuts.empty());
  REQUIRE(file.door.size() == (door ? 1 : 0));
  const geometry::PlacedSector placed = placedOf(file);
  const fit::LookUp look_up(placed, file.cuts);
  const model::Sky sky = fitSky();
  const std::vector<sectors::SectorFile> files = {file};
  const sectors::LevelLight light(files, sky, 12.0);
  const geometry::Surfaces yard = fitYard();
  const fit::FitPoints points = fit::pointsOf(geometry::Tracer(yard), {0, 0}, 300, 100, 4);
  std::vector<fit::FitPoint> all = points.surface;
  all.insert(all.end(), points.air.begin(), points.air.end());
  for (int i = 0; i < 80; ++i)  // through the door, on the ground
    all.push_back({Number3(44.0 + 0.05 * i, 0.0, kBoxLow - 4.95 + 0.1 * i), Number3(0.0, 1.0, 0.0)});
  std::size_t at_border = 0;
  for (const fit::FitPoint& p : all) {
    const fit::PointWeights weights = look_up.at(p);
    const auto want = light.at(p.position, p.normal);
    REQUIRE(want.has_value() == !weights.probe.empty());
    if (!want) continue;
    Number3 sum(0.0);
    double total = 0.0;
    for (const auto& e : weights.probe) {
      sum += light.ofProbe({0, 0}, e.probe, p.normal).sky * e.weight;
      total += e.weight;
    }
    CHECK(total == Approx(1.0).epsilon(1e-12));
    if (weights.share < 0.999) ++at_border;
    // ofProbe clamps each probe at 0, so sums may differ where a probe's light for this normal is below 0.
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(want->sky[c]).epsilon(1e-9).margin(0.02));
  }
  CHECK(at_border > 5);
}

TEST_CASE("SkyFit, AFieldThatTheLookUpHoldsIsFound") {
  constexpr std::size_t kProbes = 6, kPoints = 900;
  const fit::TrainingSkies skies({geometry::unit({1, 0.5, 0.3}), geometry::unit({-1, 0.3, 0.8})});
  geometry::Random random(5);
  const auto number = [&] { return random.unit(); };
  std::vector<transfer::ProbeTransfer> wanted(kProbes), start(kProbes);
  for (transfer::ProbeTransfer& t : wanted)
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      t.visibility[b] = b < 3 ? 0.2 + 0.6 * number() : 0.0;
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c) t.sky[b][k][c] = k < 2 ? 0.1 + 0.3 * number() : 0.2 * (number() - 0.5);
    }
  const auto basis = transfer::transferBasis();
  const auto numberOf = [&](const transfer::ProbeTransfer& t, std::size_t b, std::size_t k, int c) {
    return t.sky[b][k][c] + t.visibility[b] * det::cosineLobe(k == 0 ? 0 : 1) * det::shBasis(basis[b]).v[k];
  };
  std::vector<fit::Row> rows(kPoints);
  std::vector<fit::PointLight> light(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double s = number();
    const auto shading = transfer::shadingWeights(geometry::sphereDirection(s, number()));
    const auto first = static_cast<std::uint32_t>(number() * kProbes);
    const auto second = static_cast<std::uint32_t>((first + 1) % kProbes);
    const double share = number();
    light[i].sky.assign(skies.count(), Number3(0.0));
    for (const auto& [probe, weight] : {std::pair(first, share), std::pair(second, 1.0 - share)})
      for (std::size_t b = 0; b < transfer::kDirections; ++b) {
        const double factor = weight * shading[b];
        rows[i].entry.push_back({static_cast<std::uint32_t>(transfer::kDirections * probe + b), factor});
        for (std::size_t l = 0; l < skies.count(); ++l)
          for (std::size_t k = 0; k < 4; ++k)
            for (int c = 0; c < 3; ++c)
              light[i].sky[l][c] += factor * skies.coefficient(l)[k] * numberOf(wanted[probe], b, k, c);
      }
  }
  std::vector<transfer::ProbeTransfer*> probes;
  for (std::size_t p = 0; p < kProbes; ++p) {
    for (std::size_t b = 0; b < 3; ++b) start[p].visibility[b] = wanted[p].visibility[b] + 0.1 * (number() - 0.5);
    probes.push_back(&start[p]);
  }
  const fit::NormalMatrix matrix(transfer::kDirections * kProbes, rows, 1e-6);
  fit::fitSky(matrix, rows, light, skies, probes);
  // How visibility and bounced light share the sky is not in the light; their sum is. A fiftieth of the weight pulls
  // visibility to the start, which is up to 0.05 off.
  constexpr double kPulled = 0.01;
  for (std::size_t p = 0; p < kProbes; ++p)
    for (std::size_t b = 0; b < transfer::kDirections; ++b)
      for (std::size_t l = 0; l < skies.count(); ++l)
        for (int c = 0; c < 3; ++c) {
          double got = 0.0, want = 0.0;
          for (std::size_t k = 0; k < 4; ++k) {
            got += skies.coefficient(l)[k] * numberOf(start[p], b, k, c);
            want += skies.coefficient(l)[k] * numberOf(wanted[p], b, k, c);
          }
          CHECK(got == Approx(want).margin(kPulled));
        }
}

TEST_CASE("FitTransfer, PointsThatItHasNotSeenAreLitBetter") {
  const geometry::Surfaces yard = fitYard();
  const fit::FitPoints points = fit::pointsOf(geometry::Tracer(yard), {0, 0}, 250, 150, 99);
  const sectors::SectorFile plain = bakedYard(build::Fit::none), fitted = bakedYard(build::Fit::surfaces);
  CHECK(plain.grid == fitted.grid);
  CHECK(plain.probes.position == fitted.probes.position);
  CHECK(sectors::encodeSector(plain).size() == sectors::encodeSector(fitted).size());
  const Errors before = errorsOf(plain, points.surface), after = errorsOf(fitted, points.surface);
  CHECK(after.sky < 0.8 * before.sky);
  CHECK(after.sun < 0.8 * before.sun);
  const Errors air_before = errorsOf(plain, points.air), air_after = errorsOf(fitted, points.air);
  // Air and surfaces share the probes, so at one hour of one sky the air may pay a little (docs/probes.md).
  CHECK(air_after.sky < 1.15 * air_before.sky);
  CHECK(air_after.sun < 1.05 * air_before.sun);
}

TEST_CASE("FitTransfer, AClosedRoomStaysExactlyDark") {
  for (const placement::Walls walls : {placement::Walls::cut, placement::Walls::ignore}) {
    const sectors::SectorFile file = bakedYard(build::Fit::surfaces, walls);
    const transfer::SectorProbes probes = transfer::decodedProbes(file.probes, {0, 0});
    std::size_t inside = 0;
    for (std::size_t i = 0; i < probes.position.size(); ++i) {
      const Number3& p = probes.position[i];
      if (p.x < kBoxLow || p.x > kBoxHigh || p.z < kBoxLow || p.z > kBoxHigh || p.y > 4.0) continue;
      ++inside;
      CHECK(transfer::isUnlit(probes.transfer[i]));
      for (const auto& sun : probes.sun[i])
        for (const double v : sun) CHECK(v == 0.0);
    }
    CHECK(inside > 0);
  }
}

}  // namespace welkin::tests
