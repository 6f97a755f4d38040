// SPDX-License-Identifier: Apache-2.0
// The fifth axis of a study: size, format and number of cubemaps, and the analytic dome beside them.
#pragma once

#include "sky/cubemap/cubemap_plan.h"
#include "study/report.h"
#include "study/study_day.h"

namespace welkin::study {

/// Cubemaps at their own times: no blend.
struct CubemapSizeRow {
  int size = 0;
  format::CubemapFormat format = format::CubemapFormat::rgba16f;
  double bytes = 0.0;  ///< a cubemap
  double resolution = 0.0, encoding = 0.0;
  double error() const;  ///< the root of the sum of both squares, at the worst time
};

/// The fewest times between which a blend of the model itself stays within an error.
struct CubemapTimesRow {
  double max_error = 0.0;
  std::size_t times = 0;
};

/// The plan of cubemap::planCubemaps for a budget.
struct CubemapBudgetRow {
  double max_error = 0.0;
  cubemap::CubemapPlan plan;
  double plan_s = 0.0;
};

/// Gradients of the analytic dome.
struct DomeRow {
  model::GradientFormat format;
  double bytes = 0.0;
  double error = 0.0;
};

struct CubemapStudy {
  std::vector<CubemapSizeRow> sizes;
  std::vector<CubemapTimesRow> times;
  std::vector<CubemapBudgetRow> budgets;
  std::vector<DomeRow> dome;
};

CubemapStudy measureCubemapAxis(const model::Sky& sky, const StudyOptions& options);

/// Adds the tables "cubemaps", "cubemap_times", "cubemap_budgets" and "dome" and the chart "cubemaps".
void reportCubemaps(const CubemapStudy& study, StudyReport& report);

}  // namespace welkin::study
