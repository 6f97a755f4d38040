// SPDX-License-Identifier: Apache-2.0
#include "welkin/bake_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <regex>

#include "format/container.h"
#include "probes/hash.h"
#include "sky/atomic_file.h"
#include "sky/encode.h"
#include "sky/error.h"
#include "sky/exr.h"
#include "welkin/certificate_text.h"
#include "welkin/sky_plan.h"
#include "welkin/warnings.h"

namespace welkin::tools {
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

std::string hashText(std::span<const std::byte> bytes) {
  return probes::textOf(probes::hashOf(bytes));
}

/// Writes outputs and remembers them for the report.
struct Outputs {
  std::filesystem::path folder;
  Json list = Json::array();

  void write(const std::string& name, std::span<const std::byte> bytes) {
    writeFile(folder / name, bytes);
    list.push_back({{"file", name}, {"bytes", bytes.size()}, {"xxh3_128", hashText(bytes)}});
  }
};

/// Cubemaps of an earlier bake that this one did not write.
void removeStaleCubemaps(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  static const std::regex kOurs("(sky_[0-9]{9})(_latlong)?\\.exr(\\.tmp)?");
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::smatch match;
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, match, kOurs) &&
        (match[3].matched || std::find(names.begin(), names.end(), match[1].str()) == names.end()))
      std::filesystem::remove(entry.path(), error);
  }
}

/// The certificate of a plan's table, and the bytes of its file without cubemaps that it was measured on.
sky::Certificate measure(const sky::SkyFile& file, const SkyPlan& plan, Certify how, ProgressReport::Style style) {
  const auto bytes = sky::encodeSky(file, plan.table, {}, plan.encoding);
  WelkinSky* opened = nullptr;
  WelkinMessage message{};
  if (welkin_sky_open_memory(bytes.data(), bytes.size(), &opened, &message) != WELKIN_OK)
    throw Error(ExitStatus::internal, fmt::format("the runtime refuses what was baked: {}", message.text));
  const std::unique_ptr<WelkinSky, void (*)(WelkinSky*)> owner(opened, welkin_sky_close);
  const Baked baked{file.sky, plan.representation, plan.table, plan.encoding, plan.quadrature};
  ProgressReport progress(style, "certificate", certifySteps(baked, how));
  return certify(opened, baked, how, [&] { return progress.step(); });
}

/// A plan whose certificate is within the budget: planned again for less when what was measured, every minute and
/// through the runtime, is more than the plan expected.
struct Certified {
  SkyPlan plan;
  std::optional<sky::Certificate> certificate;
};
Certified planAndMeasure(const sky::SkyFile& file, Certify how, ProgressReport::Style style, Stopwatch& watch,
                         Json& timing) {
  constexpr int kAttempts = 4;
  SkyPlanner planner(file, style);
  double aim = file.bake.max_error.value_or(0.0);
  double plan_s = 0.0;
  double certify_s = 0.0;
  for (int attempt = 1;; ++attempt) {
    Certified result{planner.plan(aim), std::nullopt};
    plan_s += watch.lap();
    if (how != Certify::none) result.certificate = measure(file, result.plan, how, style);
    certify_s += watch.lap();
    timing["table_s"] = plan_s;
    timing["certify_s"] = certify_s;
    if (!result.certificate || !file.bake.max_error || result.certificate->max_error <= *file.bake.max_error)
      return result;
    if (attempt == kAttempts)
      throw Error(ExitStatus::content,
                  fmt::format("{}: max_error = {}: cannot be met: {} bytes make an error of {:.3g}",
                              file.inputs.front().path.string(), *file.bake.max_error, result.plan.table_bytes,
                              result.certificate->max_error));
    // Keys are few and whole: a small step may change nothing, so each is larger than the last.
    aim *= (1.0 - 0.01 * attempt) * *file.bake.max_error / result.certificate->max_error;
  }
}

std::vector<std::string> cubemapNames(const std::vector<double>& time_h) {
  std::vector<std::string> names;
  for (const double time : time_h) names.push_back(cubemapName(time));
  return names;
}

sky::Number3 groundAt(const sky::SkyProjector& projector, const sky::SkyInstant& instant) {
  return instant.groundRadiance(projector.project(instant).horizontal_irradiance);
}

std::vector<sky::Cubemap> renderCubemaps(const sky::SkyFile& file, const SkyPlan& plan, ProgressReport::Style style,
                                         std::size_t& saturated) {
  std::vector<sky::Cubemap> cubemaps;
  if (plan.cubemap_time_h.empty()) return cubemaps;
  ProgressReport progress(style, "cubemaps", plan.cubemap_time_h.size());
  const sky::SkyProjector projector(file.sky.luminance, 1);
  for (const double time_h : plan.cubemap_time_h) {
    const sky::SkyInstant instant(file.sky, time_h);
    cubemaps.push_back(sky::renderCubemap(instant, groundAt(projector, instant), plan.cubemap_size, plan.cubemap_format,
                                          [] { return !interrupted(); }));
    saturated += cubemaps.back().saturated;
    if (!progress.step()) throw Error(ExitStatus::interrupted, "interrupted; nothing was written");
  }
  return cubemaps;
}

/// The same pictures as EXR cubes and latlongs.
void writeImages(const sky::SkyFile& file, const SkyPlan& plan, Outputs& outputs, ProgressReport::Style style,
                 std::size_t& saturated) {
  const auto names = cubemapNames(plan.cubemap_time_h);
  if (names.empty()) return;
  makeFolder(outputs.folder / "cubemaps");
  ProgressReport progress(style, "images", names.size());
  const sky::SkyProjector projector(file.sky.luminance, 1);
  const sky::Progress keep_going = [] { return !interrupted(); };
  for (std::size_t i = 0; i < names.size(); ++i) {
    const sky::SkyInstant instant(file.sky, plan.cubemap_time_h[i]);
    const auto ground = groundAt(projector, instant);
    for (const auto& [layout, suffix] :
         {std::pair(sky::Layout::exr_cube, ".exr"), {sky::Layout::exr_latlong, "_latlong.exr"}}) {
      const auto image = sky::renderDome(instant, ground, layout, plan.cubemap_size, keep_going);
      saturated += image.saturated;
      outputs.write("cubemaps/" + names[i] + suffix,
                    sky::encodeExr(image, layout, file.sky.luminance_unit, keep_going));
    }
    if (!progress.step()) throw Error(ExitStatus::interrupted, "interrupted; finished files are kept");
  }
}

/// The error of the cubemaps as they are in the file.
sky::CubemapError measureCubemaps(const sky::SkyFile& file, const SkyPlan& plan,
                                  const std::vector<sky::Cubemap>& cubemaps, Certify how, ProgressReport::Style style) {
  sky::CubemapSet set{plan.cubemap_size, plan.cubemap_format, plan.cubemap_time_h, {}};
  for (const sky::Cubemap& cubemap : cubemaps) set.texels.emplace_back(cubemap.texels);
  ProgressReport progress(style, "cubemaps' error", 0);
  return sky::measureCubemaps(file.sky, set, how == Certify::full ? sky::Effort::full : sky::Effort::fast,
                              [&] { return progress.step(); });
}

Json inputsJson(const sky::SkyFile& file) {
  Json inputs = Json::array();
  for (const auto& input : file.inputs)
    inputs.push_back(
        {{"name", input.name}, {"xxh3_128", fmt::format("{:016x}{:016x}", input.xxh3_high, input.xxh3_low)}});
  return inputs;
}

}  // namespace

std::string cubemapName(double time_h) {
  const long ms = sky::millisecondOf(time_h);
  return fmt::format("sky_{:02}{:02}{:02}{:03}", ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, ms % 1000);
}

Json bakeSky(const sky::SkyFile& given, const std::filesystem::path& folder, Certify how, ProgressReport::Style style,
             Json& timing) {
  makeFolder(
      folder);  // a wrong path shows before the work, but no file is written before the budget is known to be kept
  Stopwatch watch;
  Certified certified = planAndMeasure(given, how, style, watch, timing);
  const SkyPlan& plan = certified.plan;
  sky::SkyFile file = given;
  file.bake.gradient_format = plan.gradient_format;
  file.bake.cubemap_time_h = plan.cubemap_time_h;
  file.bake.cubemap_size = plan.cubemap_size;

  std::size_t saturated = 0;
  const auto cubemaps = renderCubemaps(file, plan, style, saturated);
  double cubemaps_s = watch.lap();
  std::optional<sky::CubemapError> cubemap_error;
  if (how != Certify::none && !cubemaps.empty()) {
    cubemap_error = measureCubemaps(file, plan, cubemaps, how, style);
    if (file.bake.max_error && cubemap_error->error > *file.bake.max_error)
      throw Error(
          ExitStatus::content,
          fmt::format("{}: max_error = {}: cannot be met by {} cubemaps of {} in {}, whose error is {:.3g}; leave "
                      "cubemap_size, cubemap_times and cubemap_format to the budget, or make none",
                      file.inputs.front().path.string(), *file.bake.max_error, cubemaps.size(), plan.cubemap_size,
                      format::nameOf(plan.cubemap_format), cubemap_error->error));
    certified.certificate->cubemaps = {cubemap_error->error, cubemap_error->time_h, cubemap_error->parts.resolution,
                                       cubemap_error->parts.time, cubemap_error->parts.encoding};
    timing["certify_s"] = timing["certify_s"].get<double>() + watch.lap();
  }
  Outputs outputs{folder};
  writeImages(file, plan, outputs, style, saturated);
  cubemaps_s += watch.lap();
  timing["cubemaps_s"] = cubemaps_s;
  if (certified.certificate) certified.certificate->dome_error = plan.dome_error;
  const sky::Certificate* certificate = certified.certificate ? &*certified.certificate : nullptr;
  outputs.write("sky.welkin", sky::encodeSky(file, plan.table, cubemaps, plan.encoding, certificate));
  removeStaleCubemaps(folder / "cubemaps", cubemapNames(plan.cubemap_time_h));
  timing["write_s"] = watch.lap();

  Json warnings = warningsJson(file);
  if (saturated > 0)
    warnings.push_back(
        {{"id", "half-saturated"},
         {"count", saturated},
         {"message",
          fmt::format("{} components of the cubemaps are past the largest value of their format ({}: {}; EXR: "
                      "65504) and were stored as that; raise luminance_unit and lower intensity",
                      saturated, format::nameOf(plan.cubemap_format), format::largestOf(plan.cubemap_format, 2))}});
  constexpr double kUnsure = 0.05;
  if (certificate != nullptr && certificate->reference_error > kUnsure * certificate->max_error)
    warnings.push_back(
        {{"id", "certificate-unsure"},
         {"message", fmt::format("the certificate's own reference may be off by {:.2g}, which is more than {:.0f} % of "
                                 "the error of {:.2g} that it states: the sky's lobe is too narrow for it",
                                 certificate->reference_error, 100.0 * kUnsure, certificate->max_error)}});
  Json report = {{"format_version", format::kVersion},
                 {"inputs", inputsJson(file)},
                 {"settings", Json::parse(file.settings)},
                 {"table", planJson(plan, file.bake.max_error)},
                 {"cubemaps",
                  {{"size", plan.cubemap_size},
                   {"format", format::nameOf(plan.cubemap_format)},
                   {"time_h", plan.cubemap_time_h},
                   {"bytes", plan.cubemap_bytes}}},
                 {"gradients", {{"format", sky::nameOf(plan.gradient_format)}, {"bytes", plan.gradient_bytes}}},
                 {"left_out", leftOutJson(plan)}};
  if (certificate != nullptr) report["certificate"] = certificateJson(*certificate, cubemap_error);
  report["outputs"] = outputs.list;
  report["warnings"] = warnings;
  return report;
}

}  // namespace welkin::tools
