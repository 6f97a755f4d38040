// SPDX-License-Identifier: Apache-2.0
// The plan of a sky's bake: as its file says, or as an error budget takes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sky/bake/sky_file.h"
#include "sky/base/progress.h"
#include "sky/cubemap/cubemap_plan.h"
#include "sky/table/family_plan.h"

namespace welkin::bake {

/// A least error, > 0, as text for people: three digits, rounded up, so that a budget of that number can be met.
std::string leastText(double error);

/// Something that was not made, and what that saves.
struct LeftOut {
  std::string what, why;
  std::size_t bytes = 0;   ///< of sky.welkin
  double evaluations = 0;  ///< of the sky's radiance: what a bake's time goes into
};

struct SkyPlan {
  table::Representation representation;
  table::DayTable table;
  table::Encoding encoding = table::Encoding::float32;
  model::Quadrature quadrature;  ///< of the table's moments
  double window_strength = 0.0;  ///< sh/window.h
  double predicted_error = 0.0;  ///< of the irradiance; 0 without a budget
  std::size_t table_bytes = 0;   ///< with modes
  std::vector<table::PlanChoice> considered;
  int cubemap_size = 0;
  format::CubemapFormat cubemap_format = format::CubemapFormat::rgba16f;
  std::vector<double> cubemap_time_h;
  std::size_t cubemap_bytes = 0;
  std::optional<double> cubemap_error;  ///< as the plan of the cubemaps measured it; none where their settings stand
  model::GradientFormat gradient_format = model::GradientFormat::rgb32f;
  std::size_t gradient_bytes = 0;
  double dome_error = 0.0;  ///< of the gradients' format
  std::vector<LeftOut> left_out;
  std::vector<model::Warning> warnings;  ///< of what the plan costs
};

/// Plans one sky file, perhaps more than once.
class SkyPlanner {
 public:
  SkyPlanner(const SkyFile& file, base::Progress progress);
  ~SkyPlanner();

  /// Under the file's budget for cubemaps, and `aim`, at most that, for irradiance; without a budget, as the file says.
  /// Where no table keeps `aim`, the one of the least error, if that is within the budget. Throws Error(content) when
  /// the budget cannot be met, with the best that can be had and its cost; Error(interrupted).
  SkyPlan plan(double aim);

  /// The same in two steps, for skies that are planned together, under a budget: the day and what its table must keep;
  /// and the plan with a table that was made of these. Throws as plan.
  table::FamilyMember member(double aim);
  SkyPlan planWith(table::DayPlan table);

  /// After a plan under a budget: the next ones look at these hours of the day as well. Throws Error(interrupted).
  void lookAt(std::vector<double> time_h);

  /// table::brightestOf the sky, computed once.
  double brightest();

 private:
  struct Day;
  void planTable(double aim, SkyPlan& plan);
  void planWithoutBudget(SkyPlan& plan);
  void take(table::DayPlan table, SkyPlan& plan) const;
  void checkSettings() const;
  void sample();
  SkyPlan finished(SkyPlan plan);
  void planCubemaps(SkyPlan& plan);
  void planGradients(SkyPlan& plan);

  const SkyFile& file_;
  base::Progress progress_;
  std::optional<double> brightest_;
  std::unique_ptr<Day> day_;                      ///< sampled for the first plan under a budget
  std::optional<cubemap::CubemapPlan> cubemaps_;  ///< the same for every aim
  std::optional<double> dome_error_;              ///< of RGB9E5
};

}  // namespace welkin::bake
