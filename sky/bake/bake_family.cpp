// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/bake_family.h"

#include <fmt/format.h>

#include <algorithm>

#include "format/container.h"
#include "sky/bake/family.h"
#include "sky/bake/sky_outputs.h"
#include "sky/bake/write_sky.h"
#include "sky/base/error.h"
#include "sky/table/family_plan.h"

namespace welkin::bake {
namespace {

using Json = nlohmann::ordered_json;

/// What was planned and measured of all skies.
struct CertifiedFamily {
  std::vector<Certified> sky;
  std::vector<BlendError> blends;  ///< by pair
};

double budgetOf(const SkyFile& file) {
  return file.bake.max_error.value_or(0.0);
}

double budgetOf(std::span<const SkyFile> family, const BlendError& blend) {
  return std::max(budgetOf(family[blend.first]), budgetOf(family[blend.second]));
}

/// The largest of all errors over their budgets.
double worstRatio(std::span<const SkyFile> family, const CertifiedFamily& result) {
  double worst = 0.0;
  for (std::size_t i = 0; i < family.size(); ++i)
    worst = std::max(worst, result.sky[i].certificate->max_error / budgetOf(family[i]));
  for (const BlendError& blend : result.blends) worst = std::max(worst, blend.max_error / budgetOf(family, blend));
  return worst;
}

CertifiedFamily measureAll(std::span<const SkyFile> family, std::vector<SkyPlan> plans, FamilyPlanner& planner,
                           Certify how, const base::Progress& progress) {
  CertifiedFamily result;
  std::vector<OpenedPlan> opened;
  for (std::size_t i = 0; i < family.size(); ++i) {
    opened.emplace_back(family[i], plans[i]);
    result.sky.push_back({std::move(plans[i]), std::nullopt});
  }
  if (how == Certify::none) return result;
  std::vector<FamilySky> skies;
  for (std::size_t i = 0; i < family.size(); ++i) {
    Certified& sky = result.sky[i];
    sky.certificate = measure(opened[i], family[i], sky.plan, planner.of(i).brightest(), how, progress);
    skies.push_back({opened[i].get(), family[i].sky, sky.plan.table});
  }
  result.blends = certifyBlends(skies, progress);
  return result;
}

/// Shows the planner the hours at which an error is past what was aimed at.
void lookAtWorse(std::span<const SkyFile> family, const CertifiedFamily& result, double share, FamilyPlanner& planner) {
  std::vector<std::vector<double>> worse(family.size());
  for (std::size_t i = 0; i < family.size(); ++i)
    for (const auto& at : result.sky[i].certificate->day)
      if (at.error > share * budgetOf(family[i])) worse[i].push_back(at.time_h);
  for (const BlendError& blend : result.blends)
    for (const auto& at : blend.day)
      if (at.error > share * budgetOf(family, blend))
        for (const std::size_t sky : {blend.first, blend.second}) worse[sky].push_back(at.time_h);
  for (std::size_t i = 0; i < family.size(); ++i) {
    std::sort(worse[i].begin(), worse[i].end());
    worse[i].erase(std::unique(worse[i].begin(), worse[i].end()), worse[i].end());
    planner.of(i).lookAt(std::move(worse[i]));
  }
}

[[noreturn]] void throwUnmet(std::span<const SkyFile> family, const CertifiedFamily& best) {
  const auto name = [&](std::size_t i) { return family[i].inputs.front().path.string(); };
  for (std::size_t i = 0; i < family.size(); ++i)
    if (const auto& c = *best.sky[i].certificate; c.max_error > budgetOf(family[i]))
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: max_error = {}: cannot be met: the least error of the irradiance that was "
                                    "measured is {}, at {:.2f} h, by {}, which the skies of its family share",
                                    name(i), budgetOf(family[i]), leastText(c.max_error), c.time_h,
                                    best.sky[i].plan.representation.name()));
  const BlendError& worst =
      *std::max_element(best.blends.begin(), best.blends.end(), [&](const BlendError& a, const BlendError& b) {
        return a.max_error / budgetOf(family, a) < b.max_error / budgetOf(family, b);
      });
  throw base::Error(base::ExitStatus::content,
                    fmt::format("{}: max_error = {}: cannot be met by its blends with {}: the least error that was "
                                "measured is {}, at {:.2f} h",
                                name(worst.first), budgetOf(family, worst), name(worst.second),
                                leastText(worst.max_error), worst.time_h));
}

/// Plans whose certificates and whose blends' certificate are within the budgets, as planAndMeasure finds them.
CertifiedFamily planAndMeasureAll(std::span<const SkyFile> family, const SkyRequest& request,
                                  const base::Progress& progress, Stopwatch& watch, Json& timing) {
  constexpr int kAttempts = 8;
  constexpr double kStep = 0.005;
  FamilyPlanner planner(family, progress);
  double share = 1.0;
  std::optional<CertifiedFamily> best;
  timing["table_s"] = timing["certify_s"] = 0.0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<SkyPlan> plans = planner.plan(share);
    timing["table_s"] = timing["table_s"].get<double>() + watch.lap();
    if (attempt == 0 && request.warn)
      for (const SkyPlan& plan : plans)
        for (const model::Warning& warning : plan.warnings) request.warn(warning.message);
    CertifiedFamily result = measureAll(family, std::move(plans), planner, request.certify, progress);
    timing["certify_s"] = timing["certify_s"].get<double>() + watch.lap();
    if (request.certify == Certify::none || !family.front().bake.max_error) return result;
    const double ratio = worstRatio(family, result);
    if (ratio <= 1.0) return result;
    double of_skies = 0.0;
    for (std::size_t i = 0; i < family.size(); ++i)
      of_skies = std::max(of_skies, result.sky[i].certificate->max_error / budgetOf(family[i]));
    lookAtWorse(family, result, share, planner);
    if (!best || ratio < worstRatio(family, *best)) best = std::move(result);
    // A blend may be farther off than both skies where it is divided by less than their blended divisors. More instants
    // do not mend that.
    const bool fixed_keys = std::any_of(family.begin(), family.end(), [](const auto& f) { return f.bake.fixed.keys; });
    const bool is_far = fixed_keys || attempt > 2 || of_skies <= 1.0;
    share *= (1.0 - kStep) * (is_far ? 1.0 / ratio : 1.0);
  }
  throwUnmet(family, *best);
}

Json blendJson(std::span<const SkyFile> family, const BlendError& blend) {
  const char* channels[] = {"red", "green", "blue"};
  return {{"skies", {family[blend.first].name, family[blend.second].name}},
          {"weight", blend.weight},
          {"max_error", blend.max_error},
          {"time_h", blend.time_h},
          {"normal", {blend.normal.x, blend.normal.y, blend.normal.z}},
          {"channel", channels[blend.channel]}};
}

/// Adds to each sky's certificate what its blends add to the file and the report.
void addBlends(std::span<const SkyFile> family, CertifiedFamily& result) {
  for (const BlendError& blend : result.blends)
    for (const std::size_t i : {blend.first, blend.second}) {
      Certified& sky = result.sky[i];
      sky.blends.push_back(blendJson(family, blend));
      if (blend.max_error > sky.certificate->blends.max_error)
        sky.certificate->blends = {blend.max_error, blend.time_h};
    }
}

/// The worst of the blends that the skies' reports list; null where none was measured.
Json worstBlend(const Json& skies) {
  Json worst;
  for (const Json& sky : skies)
    if (sky.contains("certificate"))
      for (const Json& blend : sky["certificate"].value("blends", Json::array()))
        if (worst.is_null() || blend["max_error"] > worst["max_error"]) worst = blend;
  return worst;
}

}  // namespace

FamilyPlanner::FamilyPlanner(std::span<const SkyFile> family, const base::Progress& progress)
    : family_(family), progress_(progress) {
  for (const SkyFile& file : family) planner_.push_back(std::make_unique<SkyPlanner>(file, progress));
}

std::vector<SkyPlan> FamilyPlanner::plan(double share) {
  std::vector<SkyPlan> plans;
  if (!family_.front().bake.max_error || family_.size() == 1) {  // nothing to share
    for (std::size_t i = 0; i < family_.size(); ++i) plans.push_back(planner_[i]->plan(share * budgetOf(family_[i])));
    return plans;
  }
  std::vector<table::FamilyMember> members;
  for (std::size_t i = 0; i < family_.size(); ++i) members.push_back(planner_[i]->member(share * budgetOf(family_[i])));
  std::vector<table::DayPlan> tables = table::planFamily(members, progress_);
  for (std::size_t i = 0; i < family_.size(); ++i) plans.push_back(planner_[i]->planWith(std::move(tables.at(i))));
  return plans;
}

Json bakeFamily(std::vector<SkyFile> family, const std::vector<Input>& inputs, const std::filesystem::path& folder,
                const SkyRequest& request, const base::Progress& progress, Json& timing) {
  std::sort(family.begin(), family.end(), [](const SkyFile& a, const SkyFile& b) { return a.name < b.name; });
  checkFamily(family);
  relate(family);
  std::vector<SkyState> state;
  for (const SkyFile& file : family) state.push_back(skyState(folder, file, request.certify));
  const bool bakes =
      request.force || std::any_of(state.begin(), state.end(), [](const SkyState& s) { return !s.stale.empty(); });
  if (bakes) {
    Stopwatch watch;
    CertifiedFamily result = planAndMeasureAll(family, request, progress, watch, timing);
    addBlends(family, result);
    for (std::size_t i = 0; i < family.size(); ++i)
      state[i].made = writeSky(family[i], std::move(result.sky[i]), folder, request, progress, watch, timing);
  }
  timing["sky_baked"] = bakes;
  Json report = {{"format_version", format::kSkyVersion}, {"inputs", inputsJson(inputs)}};
  Json warnings = Json::array();
  for (std::size_t i = 0; i < family.size(); ++i) {
    removeLeftovers(folder, family[i].name, state[i].made["outputs"]);
    Json sky = skyReport(family[i], std::move(state[i].made));
    warnings.insert(warnings.end(), sky["warnings"].begin(), sky["warnings"].end());
    report["skies"][family[i].name] = std::move(sky);
  }
  if (Json worst = worstBlend(report["skies"]); !worst.is_null()) report["blends"] = std::move(worst);
  report["warnings"] = std::move(warnings);
  return report;
}

}  // namespace welkin::bake
