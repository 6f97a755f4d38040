// SPDX-License-Identifier: Apache-2.0
#include "study/study.h"

#include <fmt/format.h>

namespace welkin::study {
namespace {

constexpr double kStep_h = 2.5 / 60.0;  // as a plan for 0.5 % and more
constexpr double kQuickStep_h = 10.0 / 60.0;

}  // namespace

Study measureSky(const StudyDay& day, const StudyOptions& options) {
  Study study;
  study.shaders = measuredShaders();
  study.candidates = collectCandidates(day, options);
  options.progress.step();
  study.tables.budgets = measureBudgets(day, options);
  options.progress.step();
  study.keys = measureKeys(day, study.candidates, options);
  options.progress.step();
  study.tables.encodings = measureEncodings(day, study.candidates);
  study.tables.tables = measureTables(day, study.candidates, options);
  addPlans(study.tables);
  study.tables.front = frontOf(study.tables.tables);
  options.progress.step();
  study.cubemaps = measureCubemapAxis(day.sky(), options);
  options.progress.step();
  study.quadrature = measureQuadrature(day, options);
  options.progress.step();
  return study;
}

StudyReport studySky(const bake::SkyFile& file, StudyOptions options) {
  const bake::Target& target = file.bake.target;
  options.sh_bands = target.sh_bands;
  StudyReport report;
  report.title = fmt::format("Cost against error: {}", file.inputs.empty() ? "a sky" : file.inputs.front().name);
  if (target.sh_bands > 0) report.title += fmt::format(", as target \"{}\" shows it", target.name);
  const StudyDay day(file.sky, options.quick ? kQuickStep_h : kStep_h, options.progress.stage("day", 0));
  options.progress.step();
  const Study study = measureSky(day, options);
  reportTables(study.tables, report);
  reportRepresentations(file, day, study.candidates, report);
  reportKeys(study.keys, report);
  reportCubemaps(study.cubemaps, report);
  reportQuadrature(study.quadrature, report);
  report.paragraphs = conclusionOf(study, target);
  options.progress.step();
  return report;
}

}  // namespace welkin::study
