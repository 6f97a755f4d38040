// SPDX-License-Identifier: Apache-2.0
// A study of a small sky: the laws that its numbers keep for any sky, and the folder that it writes.
#include "study/study.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "sky/base/error.h"
#include "sky/table/key_placement.h"
#include "study/cubic_time.h"
#include "tests/folder.h"

namespace welkin::study {
namespace {

constexpr double kHalfHour = 0.5;

/// A clear sky in colours that change from the horizon to the zenith, without moon and stars.
bake::SkyFile clearSky() {
  bake::SkyFile file;
  model::Sky& sky = file.sky;
  sky.luminance = *model::findLuminance("cie-12");
  sky.gradient_sun = {1, 2, {1.0F, 0.7F, 0.4F, 0.3F, 0.5F, 0.9F}};
  sky.gradient_anti = {1, 2, {0.8F, 0.6F, 0.6F, 0.2F, 0.4F, 0.9F}};
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  sky.intensity = {1, {4.0, 9.0, 16.0, 21.0}, {0.1, 1.0, 1.2, 0.1}};
  sky.sun.path = model::sunPathFromPlace(48.0, 9.0, 1.0, 2012, 120);
  file.settings = "{}";
  return file;
}

TEST_CASE("StudyDay, MoreBandsAndModesLoseLess") {
  const bake::SkyFile file = clearSky();
  const StudyDay day(file.sky, kHalfHour, {});
  const auto candidates = collectCandidates(day, {.quick = true});
  const auto errorOf = [&](const std::string& name) {
    for (const Candidate& candidate : candidates)
      if (candidate.name == name) return candidate.error;
    FAIL("no candidate is called " << name);
    return 0.0;
  };
  CHECK(errorOf("3 bands") < errorOf("2 bands"));
  CHECK(errorOf("5 bands") < errorOf("3 bands"));
  for (const char* bands : {"2 bands", "3 bands", "5 bands"}) {
    CHECK(errorOf(std::string(bands) + ", fitted") < errorOf(bands));
    CHECK(errorOf(std::string(bands) + ", mildest window") >= errorOf(bands) * 0.999);
  }
  CHECK(errorOf("4 modes, map 25 x 25") < 0.3 * errorOf("2 modes, map 25 x 25"));
  CHECK(errorOf("6 modes, map 25 x 25") < errorOf("4 modes, map 25 x 25"));
  CHECK(errorOf("6 modes, map 25 x 25, fitted") <= errorOf("6 modes, map 25 x 25"));
}

TEST_CASE("StudyDay, BytesOfAWayAreThoseOfItsTable") {
  bake::SkyFile file = clearSky();
  file.sky.ground_albedo = det::Number3(0.1, 0.2, 0.3);
  const StudyDay day(file.sky, kHalfHour, {});
  const DayWeights modes = modeWeights(day, table::DayModes(day.fields(), day.grid()), 3);
  for (const Candidate& candidate :
       {bandsCandidate(day, 3, Fit::projected), modesCandidate(day, modes, kSmallMap, Fit::projected)})
    for (const auto encoding : format::kEncodings) {
      const auto keys = evenKeys(day, 12);
      const table::DayTable table = table::tableAt(day.values(), candidate.representation, keys);
      CHECK(candidate.bytes(day.sky(), keys.size(), encoding) ==
            table::bytesOf(candidate.representation, table, encoding));
    }
}

TEST_CASE("StudyKeys, MoreEvenKeysErrLessAndPlacedOnesLeast") {
  const bake::SkyFile file = clearSky();
  const StudyDay day(file.sky, 0.25, {});
  const Candidate candidate = bandsCandidate(day, 5, Fit::projected);
  double before = 1e9;
  for (const std::size_t keys : {6, 12, 24, 48}) {
    const auto even = evenKeys(day, keys);
    REQUIRE(even.size() == keys);
    const double error = linearError(day.values(), candidate.representation, even);
    const table::DayTable table = table::tableAt(day.values(), candidate.representation, even);
    CHECK(error == Approx(table::errorOf(day.values(), candidate.representation, table, table::Encoding::float32).value)
                       .epsilon(1e-4));  // float32 rounds by 6e-8
    CHECK(error < before);
    before = error;
  }
  const auto placed = table::placeKeys(day.values(), candidate.representation, before);
  REQUIRE(!placed.empty());
  CHECK(placed.size() < 48);
  CHECK(placeHermiteKeys(day.values(), candidate.representation, before).size() <= placed.size());
}

/// The largest error of interpolating a day whose irradiance is the same in all directions, `value` of the hour.
double errorBetween(const StudyDay& day, double (*value)(double time_h), bool cubic) {
  table::Representation r = bandsCandidate(day, 2, Fit::projected).representation;
  table::DayValues values = day.values();
  for (std::size_t i = 0; i < day.count(); ++i) {
    for (std::size_t k = 0; k < r.rows; ++k)
      r.weight[i * r.rows + k] = det::Number3(k == 0 ? value(day.fields().instant[i].time_h) : 0.0);
    for (std::size_t p = 0; p < day.grid().count(); ++p)
      values.value[i * day.grid().count() + p] = r.weight[i * r.rows] * r.values[p * r.functions];
  }
  const auto keys = evenKeys(day, 24);
  return cubic ? catmullRomError(values, r, keys) : linearError(values, r, keys);
}

TEST_CASE("CubicTime, FollowsASmoothDayAndNotABend") {
  const bake::SkyFile file = clearSky();
  const StudyDay day(file.sky, 0.25, {});
  const auto smooth = [](double t) { return 2.0 + det::cos(det::kTwoPi * t / format::kDay_h); };
  CHECK(errorBetween(day, smooth, true) < 0.1 * errorBetween(day, smooth, false));
  const auto bent = [](double t) { return 2.0 + std::abs(t - 12.5); };  // between two keys
  CHECK(errorBetween(day, bent, true) > 0.5 * errorBetween(day, bent, false));
}

TEST_CASE("Pareto, TheFrontFallsAndNothingLiesBelowIt") {
  const bake::SkyFile file = clearSky();
  const StudyDay day(file.sky, kHalfHour, {});
  TableStudy study;
  study.tables = measureTables(day, collectCandidates(day, {.quick = true}), {.quick = true});
  study.front = frontOf(study.tables);
  REQUIRE(study.front.size() > 3);
  for (std::size_t i = 1; i < study.front.size(); ++i) {
    CHECK(study.tables[study.front[i]].bytes > study.tables[study.front[i - 1]].bytes);
    CHECK(study.tables[study.front[i]].error < study.tables[study.front[i - 1]].error);
  }
  for (const MeasuredTable& table : study.tables) {
    double least = 1e9;
    for (const std::size_t i : study.front)
      if (study.tables[i].bytes <= table.bytes) least = study.tables[i].error;
    CHECK(table.error >= least);
  }
}

TEST_CASE("Study, QuadratureKeepsItsTolerances") {
  const bake::SkyFile file = clearSky();
  const StudyDay day(file.sky, kHalfHour, {});
  const QuadratureStudy study = measureQuadrature(day, {.quick = true});
  REQUIRE(study.quadrature.size() == 4);
  for (std::size_t i = 0; i + 1 < study.quadrature.size(); ++i) {
    CHECK(study.quadrature[i].error <= study.quadrature[i].tolerance);
    CHECK(study.quadrature[i].evaluations < study.quadrature[i + 1].evaluations);
  }
  CHECK(study.irradiance.front().error < model::IrradianceProjector::kError);
}

TEST_CASE("Study, WritesWhatItMeasured") {
  const tests::Folder folder;
  const base::Progress progress([](const base::Progress::Stage&, base::Progress::Event) { return true; });
  const StudyReport report = studySky(clearSky(), {.quick = true, .progress = progress});
  CHECK(progress.done() == kAxes);
  writeReport(report, folder / "out");
  const auto files = tests::filesUnder(folder / "out");
  CHECK(files.size() == 2 * report.tables.size() + 2 * report.charts.size() + 1);
  for (const StudyTable& table : report.tables) {
    const auto json = nlohmann::json::parse(tests::readBytes(folder / ("out/" + table.name + ".json")));
    CHECK(json["rows"].size() == table.table.rows().size());
    CHECK(json["rows"].size() > 0);
  }
  for (const std::string& paragraph : report.paragraphs) {
    INFO(paragraph);
    CHECK(paragraph.size() > 40);
    CHECK(paragraph.find("nan") == std::string::npos);
  }
}

TEST_CASE("Study, StopsWhenTold") {
  const bake::SkyFile file = clearSky();
  const StudyDay day(file.sky, 2.0, {});
  const base::Progress progress([](const base::Progress::Stage& stage, base::Progress::Event) {
    return stage.around() != nullptr || stage.done() < 2;  // the second axis is the last
  });
  CHECK_THROWS_AS(measureSky(day, {.quick = true, .progress = progress}), base::Error);
  CHECK(progress.done() == 2);
}

}  // namespace
}  // namespace welkin::study
