// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/write_sky.h"

#include <fmt/format.h>

#include "sky/bake/certificate_json.h"
#include "sky/bake/encode.h"
#include "sky/bake/sky_cubemaps.h"
#include "sky/bake/sky_outputs.h"
#include "sky/bake/sky_plan_json.h"
#include "sky/bake/warnings.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/hash.h"

namespace welkin::bake {

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

OpenedPlan::OpenedPlan(const SkyFile& file, const SkyPlan& plan)
    : bytes_(encodeSky(file, plan.table, {}, plan.encoding)), sky_(nullptr, welkin_sky_close) {
  WelkinSky* opened = nullptr;
  WelkinMessage message{};
  if (welkin_sky_open_memory(bytes_.data(), bytes_.size(), &opened, &message) != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal, fmt::format("the runtime refuses what was baked: {}", message.text));
  sky_.reset(opened);
}

table::Certificate measure(const OpenedPlan& opened, const SkyFile& file, const SkyPlan& plan, double brightest,
                           Certify how, const base::Progress& progress) {
  const Baked baked{file.sky,        plan.representation, plan.table,          plan.encoding,
                    plan.quadrature, brightest,           plan.window_strength};
  return certify(opened.get(), baked, how, progress.stage("certificate", certifySteps(baked, how)));
}

Json writeSky(const SkyFile& given, Certified certified, const std::filesystem::path& folder, const SkyRequest& request,
              const base::Progress& progress, Stopwatch& watch, Json& timing) {
  const Certify how = request.certify;
  const SkyPlan& plan = certified.plan;
  const auto addTime = [&](const char* part, double seconds) { timing[part] = timing.value(part, 0.0) + seconds; };
  SkyFile file = given;
  file.bake.gradient_format = plan.gradient_format;
  file.bake.cubemap_time_h = plan.cubemap_time_h;
  file.bake.cubemap_size = plan.cubemap_size;

  std::size_t saturated = 0;
  const auto cubemaps = renderCubemaps(file, plan, progress, saturated);
  const double cubemaps_s = watch.lap();
  std::optional<cubemap::CubemapError> cubemap_error;
  if (how != Certify::none && !cubemaps.empty()) {
    cubemap_error = measureCubemaps(file, plan, cubemaps, how, progress);
    requireWithinBudget(file, plan, *cubemap_error);
    certified.certificate->cubemaps = {cubemap_error->error, cubemap_error->time_h, cubemap_error->parts.resolution,
                                       cubemap_error->parts.time, cubemap_error->parts.encoding};
    addTime("certify_s", watch.lap());
  }
  SkyOutputs outputs(folder);
  writeImages(file, plan, outputs, progress, saturated);
  addTime("cubemaps_s", cubemaps_s + watch.lap());
  if (certified.certificate) certified.certificate->dome_error = plan.dome_error;
  const table::Certificate* certificate = certified.certificate ? &*certified.certificate : nullptr;
  const auto bytes = encodeSky(file, plan.table, cubemaps, plan.encoding, certificate);
  outputs.add(file.name + ".welkin", bytes);
  Json made = planJson(plan, file.bake.max_error);
  if (certificate != nullptr) made["certificate"] = certificateJson(*certificate, cubemap_error);
  if (!certified.blends.is_null()) made["certificate"]["blends"] = std::move(certified.blends);
  made["outputs"] = outputs.list();
  for (Json& warning : warningsOf(certificate, saturated, plan.cubemap_format))
    made["warnings"].push_back(std::move(warning));
  // First the record, which fits no other sky: once NAME.welkin is there, the bake is done.
  base::writeFile(folder / (file.name + ".json"), recordText(given, how, made));
  base::writeFile(folder / (file.name + ".welkin"), bytes);
  addTime("write_s", watch.lap());
  return made;
}

Json skyReport(const SkyFile& file, Json made) {
  Json report = {{"settings", Json::parse(file.settings)}, {"target", file.bake.target.name}};
  Json warnings = warningsJson(file.warnings);
  warnings.insert(warnings.end(), made["warnings"].begin(), made["warnings"].end());
  report.update(made);
  report["warnings"] = std::move(warnings);
  return report;
}

Json inputsJson(const std::vector<Input>& inputs) {
  Json list = Json::array();
  for (const auto& input : inputs)
    list.push_back({{"name", input.name}, {"xxh3_128", base::textOf({input.xxh3_low, input.xxh3_high})}});
  return list;
}

}  // namespace welkin::bake
