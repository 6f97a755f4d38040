// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/bake_sky.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "format/container.h"
#include "sky/bake/certificate_json.h"
#include "sky/bake/encode.h"
#include "sky/bake/sky_cubemaps.h"
#include "sky/bake/sky_plan_json.h"
#include "sky/bake/warnings.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/hash.h"

namespace welkin::bake {
namespace {

using Json = nlohmann::ordered_json;

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The certificate of a plan's table, and the bytes of its file without cubemaps that it was measured on.
table::Certificate measure(const SkyFile& file, const SkyPlan& plan, double brightest, Certify how,
                           const base::Progress& progress) {
  const auto bytes = encodeSky(file, plan.table, {}, plan.encoding);
  WelkinSky* opened = nullptr;
  WelkinMessage message{};
  if (welkin_sky_open_memory(bytes.data(), bytes.size(), &opened, &message) != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal, fmt::format("the runtime refuses what was baked: {}", message.text));
  const std::unique_ptr<WelkinSky, void (*)(WelkinSky*)> owner(opened, welkin_sky_close);
  const Baked baked{file.sky,        plan.representation, plan.table,          plan.encoding,
                    plan.quadrature, brightest,           plan.window_strength};
  return certify(opened, baked, how, progress.stage("certificate", certifySteps(baked, how)));
}

/// A plan whose certificate is within the budget. A certificate looks at more instants than a plan. Where it finds
/// more than the budget, the sky is planned again with those instants in sight, and for a little less.
struct Certified {
  SkyPlan plan;
  std::optional<table::Certificate> certificate;
};
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
      result.certificate = measure(file, result.plan, planner.brightest(), request.certify, progress);
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

Json inputsJson(const std::vector<Input>& inputs) {
  Json list = Json::array();
  for (const auto& input : inputs)
    list.push_back({{"name", input.name}, {"xxh3_128", base::textOf({input.xxh3_low, input.xxh3_high})}});
  return list;
}

Json warningsOf(const table::Certificate* certificate, std::size_t saturated, format::CubemapFormat format) {
  Json warnings = Json::array();
  if (saturated > 0)
    warnings.push_back(
        {{"id", "half-saturated"},
         {"count", saturated},
         {"message",
          fmt::format("{} components of the cubemaps are past the largest value of their format ({}: {}; EXR: "
                      "65504) and were stored as that; raise luminance_unit and lower intensity",
                      saturated, format::nameOf(format), format::largestOf(format, 2))}});
  // Every sky's reference may be off by kError. Where a smaller error is stated there is nothing to mend.
  constexpr double kUnsure = 0.05, kOfEverySky = 2.0 * model::IrradianceProjector::kError;
  if (certificate != nullptr && certificate->reference_error > kOfEverySky &&
      certificate->reference_error > kUnsure * certificate->max_error)
    warnings.push_back(
        {{"id", "certificate-unsure"},
         {"message", fmt::format("the certificate's own reference may be off by {:.2g}, which is more than {:.0f} % of "
                                 "the error of {:.2g} that it states: the sky's lobe is too narrow for it",
                                 certificate->reference_error, 100.0 * kUnsure, certificate->max_error)}});
  return warnings;
}

/// Throws where cubemaps are past a budget that was stated for them, or past max_error where the file fixes them.
void requireWithinBudget(const SkyFile& file, const SkyPlan& plan, const cubemap::CubemapError& error) {
  const bool is_own = file.bake.cubemap_error.has_value();
  const std::optional<double> budget = is_own                     ? file.bake.cubemap_error
                                       : file.bake.fixed.cubemaps ? file.bake.max_error
                                                                  : std::nullopt;
  if (!budget || error.error <= *budget) return;
  throw base::Error(base::ExitStatus::content,
                    fmt::format("{}: {} = {}: cannot be met by {} cubemaps of {} in {}, whose error is {}; leave "
                                "cubemap_size, cubemap_times and cubemap_format to the budget, or make none",
                                file.inputs.front().path.string(), is_own ? "cubemap_error" : "max_error", *budget,
                                plan.cubemap_time_h.size(), plan.cubemap_size, format::nameOf(plan.cubemap_format),
                                leastText(error.error)));
}

/// Bakes anew, and says what was made.
Json bakeAnew(const SkyFile& given, const std::filesystem::path& folder, const SkyRequest& request,
              const base::Progress& progress, Json& timing) {
  Stopwatch watch;
  const Certify how = request.certify;
  Certified certified = planAndMeasure(given, request, progress, watch, timing);
  const SkyPlan& plan = certified.plan;
  SkyFile file = given;
  file.bake.gradient_format = plan.gradient_format;
  file.bake.cubemap_time_h = plan.cubemap_time_h;
  file.bake.cubemap_size = plan.cubemap_size;

  std::size_t saturated = 0;
  const auto cubemaps = renderCubemaps(file, plan, progress, saturated);
  double cubemaps_s = watch.lap();
  std::optional<cubemap::CubemapError> cubemap_error;
  if (how != Certify::none && !cubemaps.empty()) {
    cubemap_error = measureCubemaps(file, plan, cubemaps, how, progress);
    requireWithinBudget(file, plan, *cubemap_error);
    certified.certificate->cubemaps = {cubemap_error->error, cubemap_error->time_h, cubemap_error->parts.resolution,
                                       cubemap_error->parts.time, cubemap_error->parts.encoding};
    timing["certify_s"] = timing["certify_s"].get<double>() + watch.lap();
  }
  SkyOutputs outputs(folder);
  writeImages(file, plan, outputs, progress, saturated);
  cubemaps_s += watch.lap();
  timing["cubemaps_s"] = cubemaps_s;
  if (certified.certificate) certified.certificate->dome_error = plan.dome_error;
  const table::Certificate* certificate = certified.certificate ? &*certified.certificate : nullptr;
  const auto bytes = encodeSky(file, plan.table, cubemaps, plan.encoding, certificate);
  outputs.add("sky.welkin", bytes);
  Json made = planJson(plan, file.bake.max_error);
  if (certificate != nullptr) made["certificate"] = certificateJson(*certificate, cubemap_error);
  made["outputs"] = outputs.list();
  for (Json& warning : warningsOf(certificate, saturated, plan.cubemap_format))
    made["warnings"].push_back(std::move(warning));
  // First the record, which fits no other sky: once sky.welkin is there, the bake is done.
  base::writeFile(folder / "sky.json", recordText(given.bake, how, made));
  base::writeFile(folder / "sky.welkin", bytes);
  timing["write_s"] = watch.lap();
  return made;
}

}  // namespace

Json bakeSky(const SkyFile& file, const std::vector<Input>& inputs, const std::filesystem::path& folder,
             const SkyRequest& request, const base::Progress& progress, Json& timing) {
  SkyState state = skyState(folder, file, request.certify);
  const bool bakes = request.force || !state.stale.empty();
  if (bakes) state.made = bakeAnew(file, folder, request, progress, timing);
  timing["sky_baked"] = bakes;
  removeLeftovers(folder, state.made["outputs"]);
  Json report = {{"format_version", format::kSkyVersion},
                 {"inputs", inputsJson(inputs)},
                 {"settings", Json::parse(file.settings)},
                 {"target", file.bake.target.name}};
  report.update(state.made);
  Json warnings = warningsJson(file.warnings);
  warnings.insert(warnings.end(), state.made["warnings"].begin(), state.made["warnings"].end());
  report["warnings"] = std::move(warnings);
  return report;
}

}  // namespace welkin::bake
