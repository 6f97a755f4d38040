// SPDX-License-Identifier: Apache-2.0
// The search for the spreads of a level's probes, beside the level's own certificate.
#include "probes/build/surface_budget.h"

#include <catch2/catch.hpp>

#include "fit_level.h"
#include "probes/build/certify_bake.h"
#include "sky/base/error.h"

namespace welkin::tests {
namespace {

/// A yard with walls in one sector and bare ground in the others.
build::LevelBake yardWithin(double max_error) {
  build::BakeSection section = fitSection(build::Fit::surfaces);
  section.transfer.rays = 256;
  section.max_surface_error = max_error;
  return {fitYard(), section, fitSky(), std::nullopt};
}

bake::SkyFile skyFile() {
  bake::SkyFile file;
  file.sky = fitSky();
  return file;
}

}  // namespace

TEST_CASE("LevelCertificate, ASentenceTellsOfAPartThatIsWorseThanNothing") {
  using Json = nlohmann::ordered_json;
  const Json good = {{"rms", 0.1}, {"nothing", 0.5}, {"worse_than_nothing", false}};
  const Json bad = {{"rms", 0.354}, {"nothing", 0.25}, {"worse_than_nothing", true}};
  const Json parts = {{"sky", good}, {"sun_bounce", bad}, {"local", good}};
  CHECK(
      build::worseThanNothing({{"surface", parts}, {"air", {{"sky", good}}}}) ==
      std::vector<std::string>{"bounced light of sun and moon on surfaces is 35.4 % off; if it were left out, 25.0 %"});
  // A report of an older bake does not say.
  CHECK(build::worseThanNothing({{"surface", {{"sky", {{"rms", 0.1}}}}}, {"air", Json::object()}}).empty());
}

TEST_CASE("SurfaceBudgetSearch, TheErrorIsThatOfTheFilesItNames", "[slow]") {
  const build::LevelBake level = yardWithin(0.9);
  const build::SurfaceChoice choice = build::chooseSpreads(level, skyFile(), false, {});
  REQUIRE(choice.file.size() == level.sectors().size());
  CHECK(choice.kept);
  std::size_t probes = 0;
  for (std::size_t i = 0; i < choice.file.size(); ++i) {
    CHECK(choice.spread[i] == build::kSpreads[0]);
    CHECK(sectors::encodeSector(choice.file[i]) ==
          sectors::encodeSector(level.bake(level.sectors()[i], {}, choice.spread[i])));
    probes += choice.file[i].probes.probes();
  }
  const auto found = certify::certifyLevel(geometry::Tracer(level.surfaces()), fitSky(), choice.file,
                                           build::certifySettings(level, probes, bake::Certify::fast));
  CHECK(choice.error == std::max(found.surface.total.rms, found.air.total.rms));
}

TEST_CASE("SurfaceBudgetSearch, ClosestProbesStandWhereTheErrorIs", "[slow]") {
  const double widest = build::chooseSpreads(yardWithin(1.0), skyFile(), false, {}).error;
  const build::LevelBake level = yardWithin(0.92 * widest);
  const build::SurfaceChoice choice = build::chooseSpreads(level, skyFile(), false, {});
  // The ground of the other sectors is bare: few probes light it as well as many.
  std::size_t most = 0;
  for (std::size_t i = 0; i < choice.file.size(); ++i)
    if (choice.file[i].probes.probes() > choice.file[most].probes.probes()) most = i;
  CHECK(level.sectors()[most] == geometry::SectorId{0, 0});
  CHECK(choice.spread[most] < build::kSpreads[0]);
  CHECK(choice.error < widest);
  CHECK(choice.kept == (choice.error <= 0.92 * widest));
}

TEST_CASE("SurfaceBudgetSearch, SpreadsScaleDistancesAlone") {
  placement::PlacementSettings settings;
  settings.minimum_separation_m = 7.0;
  const placement::PlacementSettings same = placement::spreadBy(1.0, settings);
  CHECK(same.minimum_separation_m == 7.0);
  CHECK(same.spacing_m == settings.spacing_m);
  CHECK(same.coverage_m == settings.coverage_m);
  const placement::PlacementSettings wide = placement::spreadBy(2.0, settings);
  CHECK(wide.minimum_separation_m == 14.0);
  CHECK(wide.spacing_m == settings.spacing_m);  // ground is looked for as before
  CHECK(wide.vegetation_spacing_m == settings.vegetation_spacing_m);
  CHECK(wide.coverage_m == 2.0 * settings.coverage_m);
  settings.spacing_m = 0.3;
  const placement::PlacementSettings close = placement::spreadBy(0.5, settings);
  CHECK(close.minimum_separation_m == 3.5);
  CHECK(close.spacing_m == 0.25);  // the least that [probes] allows
  CHECK(close.height_m == settings.height_m);
  CHECK(close.clearance_m == settings.clearance_m);
}

TEST_CASE("SurfaceBudgetSearch, APartOfALevelHasNoBudget") {
  const build::LevelBake level = yardWithin(0.9);
  CHECK_THROWS_AS(build::chooseSpreads(level, skyFile(), true, {}), base::Error);
}

}  // namespace welkin::tests
