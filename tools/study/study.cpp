// SPDX-License-Identifier: Apache-2.0
#include "study/study.h"

#include <fmt/format.h>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

constexpr double kStep_h = 2.5 / 60.0;  // as a plan for 0.5 % and more
constexpr double kQuickStep_h = 10.0 / 60.0;

void require(bool keep_going) {
  if (!keep_going) throw base::Error(base::ExitStatus::interrupted, "interrupted; nothing was written");
}

}  // namespace

Study measureSky(const StudyDay& day, const StudyOptions& options) {
  const auto axisDone = [&] {
    require(!options.interrupt || options.interrupt());
    require(!options.progress || options.progress());
  };
  Study study;
  study.shaders = measuredShaders();
  study.candidates = collectCandidates(day, options);
  axisDone();
  study.tables.budgets = measureBudgets(day, options);
  axisDone();
  study.keys = measureKeys(day, study.candidates, options);
  axisDone();
  study.tables.encodings = measureEncodings(day, study.candidates);
  study.tables.tables = measureTables(day, study.candidates, options);
  addPlans(study.tables);
  study.tables.front = frontOf(study.tables.tables);
  axisDone();
  study.cubemaps = measureCubemapAxis(day.sky(), options);
  axisDone();
  study.quadrature = measureQuadrature(day, options);
  axisDone();
  return study;
}

StudyReport studySky(const bake::SkyFile& file, const StudyOptions& options) {
  const table::Progress interrupt = [&] { return !options.interrupt || options.interrupt(); };
  StudyReport report;
  report.title = fmt::format("Cost against error: {}", file.inputs.empty() ? "a sky" : file.inputs.front().name);
  const StudyDay day(file.sky, options.quick ? kQuickStep_h : kStep_h, interrupt);
  require(!options.progress || options.progress());
  const Study study = measureSky(day, options);
  reportTables(study.tables, report);
  reportRepresentations(file, day, study.candidates, report);
  reportKeys(study.keys, report);
  reportCubemaps(study.cubemaps, report);
  reportQuadrature(study.quadrature, report);
  report.paragraphs = conclusionOf(study);
  require(!options.progress || options.progress());
  return report;
}

}  // namespace welkin::study
