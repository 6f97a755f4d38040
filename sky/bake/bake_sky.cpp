// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/bake_sky.h"

#include <fmt/format.h>

#include <optional>

#include "format/container.h"
#include "sky/bake/sky_outputs.h"
#include "sky/bake/write_sky.h"
#include "sky/base/error.h"

namespace welkin::bake {
namespace {

using Json = nlohmann::ordered_json;

/// A plan whose certificate is within the budget. A certificate looks at more instants than a plan. Where it finds
/// more than the budget, the sky is planned again with those instants in sight, and for a little less.
Certified planAndMeasure(const SkyFile& file, const SkyRequest& request, const base::Progress& progress,
                         Stopwatch& watch, Json& timing) {
  constexpr int kAttempts = 8;
  constexpr double kStep = 0.005;  // of the budget, that each attempt aims lower at least
  SkyPlanner planner(file, progress);
  const double budget = file.bake.max_error.value_or(0.0);
  double aim = budget;
  std::optional<Certified> best;
  double plan_s = 0.0;
  double certify_s = 0.0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Certified result{planner.plan(aim), std::nullopt};
    plan_s += watch.lap();
    if (attempt == 0 && request.warn)
      for (const model::Warning& warning : result.plan.warnings) request.warn(warning.message);
    if (request.certify != Certify::none)
      result.certificate =
          measure(OpenedPlan(file, result.plan), file, result.plan, planner.brightest(), request.certify, progress);
    certify_s += watch.lap();
    timing["table_s"] = plan_s;
    timing["certify_s"] = certify_s;
    if (!result.certificate || !file.bake.max_error || result.certificate->max_error <= budget) return result;
    if (!best || result.certificate->max_error < best->certificate->max_error) best = result;
    std::vector<double> worse;
    for (const auto& at : result.certificate->day)
      if (at.error > aim) worse.push_back(at.time_h);
    planner.lookAt(std::move(worse));
    // Fixed keys do not go where they are needed: there only a lower aim gives another plan.
    const bool is_far = file.bake.fixed.keys || attempt > 2;
    aim *= (1.0 - kStep) * (is_far ? budget / result.certificate->max_error : 1.0);
  }
  throw base::Error(
      base::ExitStatus::content,
      fmt::format("{}: max_error = {}: cannot be met: the least error of the irradiance that was measured is {}, at "
                  "{:.2f} h, by {}, {} keys and {} numbers: {} bytes",
                  file.inputs.front().path.string(), budget, leastText(best->certificate->max_error),
                  best->certificate->time_h, best->plan.representation.name(), best->plan.table.key_time_h.size(),
                  nameOf(best->plan.encoding), best->plan.table_bytes));
}

}  // namespace

Json bakeSky(const SkyFile& file, const std::vector<Input>& inputs, const std::filesystem::path& folder,
             const SkyRequest& request, const base::Progress& progress, Json& timing) {
  SkyState state = skyState(folder, file, request.certify);
  const bool bakes = request.force || !state.stale.empty();
  if (bakes) {
    Stopwatch watch;
    Certified certified = planAndMeasure(file, request, progress, watch, timing);
    state.made = writeSky(file, std::move(certified), folder, request, progress, watch, timing);
  }
  timing["sky_baked"] = bakes;
  removeLeftovers(folder, file.name, state.made["outputs"]);
  Json report = {{"format_version", format::kSkyVersion}, {"inputs", inputsJson(inputs)}};
  report.update(skyReport(file, std::move(state.made)));
  return report;
}

}  // namespace welkin::bake
