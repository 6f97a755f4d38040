// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sky/bake/left_out.h"
#include "sky/bake/mildest_window.h"
#include "sky/base/error.h"
#include "sky/cubemap/dome_error.h"

namespace welkin::bake {
namespace {

/// Hours between the instants that a plan looks at: as fine as the error is small.
double samplingStep_h(double max_error) {
  constexpr double kFine = 0.005;
  return (max_error < kFine ? 1.25 : 2.5) / 60.0;
}

std::vector<double> instantsFor(const SkyFile& file, double step_h) {
  std::vector<double> hours = table::hoursOfInterest(file.sky, step_h);
  if (file.bake.fixed.keys || !file.bake.max_error)
    hours.insert(hours.end(), file.bake.key_time_h.begin(), file.bake.key_time_h.end());
  std::sort(hours.begin(), hours.end());
  hours.erase(std::unique(hours.begin(), hours.end()), hours.end());
  return hours;
}

base::Error cannotMeet(const SkyFile& file, const char* key, double budget, const std::string& best) {
  return {base::ExitStatus::content,
          fmt::format("{}: {} = {}: cannot be met: {}", file.inputs.front().path.string(), key, budget, best)};
}

constexpr const char* kNoCubemaps =
    "--cubemaps none (cubemap_size = 0) leaves them out: the runtime draws the sky's dome by its formula";

/// Of cubemaps that do not keep a budget which was not stated for them.
model::Warning shortOf(const cubemap::CubemapPlan& plan, double budget) {
  const std::string error = fmt::format("the error of the cubemaps is {} %, above {:g} %",
                                        leastText(100.0 * plan.measured.error), 100.0 * budget);
  const std::string wanted = plan.wanted_bytes > 0.0 ? fmt::format("about {:.0f} MB", 1e-6 * plan.wanted_bytes)
                                                     : std::string("more than 1500 MB");
  const bool room = plan.wanted_bytes > 0.0 && plan.wanted_bytes <= kCubemapBytes;  // more bytes would not help
  return {
      "cubemaps-over-budget", 1,
      fmt::format(
          "{}; --cubemaps E (cubemap_error = E) is a budget of their own; {}",
          room ? error : fmt::format("within {:.0f} MB {}, which would take {}", 1e-6 * kCubemapBytes, error, wanted),
          kNoCubemaps)};
}

model::Warning largeCubemaps(const SkyPlan& plan) {
  return {"cubemaps-large", 1,
          fmt::format("{} cubemaps of {} in {} take {:.0f} MB; a larger --cubemaps E (cubemap_error = E) takes fewer; "
                      "{}",
                      plan.cubemap_time_h.size(), plan.cubemap_size, format::nameOf(plan.cubemap_format),
                      1e-6 * static_cast<double>(plan.cubemap_bytes), kNoCubemaps)};
}

}  // namespace

std::string leastText(double error) {
  const double digit = std::pow(10.0, std::floor(std::log10(error)) - 2.0);
  return fmt::format("{:.3g}", std::ceil(error / digit) * digit);
}

/// Throws Error(content) where the file fixes what its target cannot read.
void checkTarget(const SkyFile& file) {
  const BakeSettings& bake = file.bake;
  if (bake.target.sh_bands == 0) return;
  const bool wants_modes = bake.fixed.reconstruction && bake.reconstruction == table::Reconstruction::modes;
  if (!wants_modes && bake.bands <= bake.target.sh_bands) return;
  const std::string set =
      wants_modes ? std::string("reconstruction = \"modes\"") : fmt::format("bands = {}", bake.bands);
  throw base::Error(base::ExitStatus::content,
                    fmt::format("{}: bake.{}: target = \"{}\" reads coefficients of at most {} bands",
                                file.inputs.front().path.string(), set, bake.target.name, bake.target.sh_bands));
}

/// The quadrature may take a hundredth of a budget: the rest is worth more to keys and modes than panels are to time.
const model::IrradianceRule& ruleFor(const SkyFile& file) {
  constexpr double kShare = 0.01;
  return model::irradianceRuleFor(kShare * file.bake.max_error.value_or(0.0));
}

/// The day as plans look at it.
struct SkyPlanner::Day {
  table::ErrorGrid grid;
  table::DayFields fields;
  table::DayValues values;

  Day(const SkyFile& file, double step_h, double brightest, const base::Progress& progress)
      : fields(table::sampleDay(file.sky, instantsFor(file, step_h), brightest, progress, ruleFor(file))),
        values(fields, grid) {}

  /// Adds hours, ascending, but for those within a second of another one.
  void add(const std::vector<double>& time_h, double brightest, const base::Progress& progress,
           const model::IrradianceRule& rule) {
    std::vector<double> fresh;
    std::vector<double> there;
    for (const auto& at : fields.instant) there.push_back(at.time_h);
    const auto isApart = [](double t, const std::vector<double>& list) {
      constexpr double kSecond_h = 1.0 / 3600.0;
      const auto after = std::lower_bound(list.begin(), list.end(), t);
      return (after == list.end() || *after - t >= kSecond_h) &&
             (after == list.begin() || t - *std::prev(after) >= kSecond_h);
    };
    for (const double t : time_h)
      if (isApart(t, there) && isApart(t, fresh)) fresh.push_back(t);
    auto more = table::sampleDay(*fields.sky, fresh, brightest, progress, rule).instant;
    fields.instant.insert(fields.instant.end(), std::make_move_iterator(more.begin()),
                          std::make_move_iterator(more.end()));
    std::sort(fields.instant.begin(), fields.instant.end(),
              [](const auto& a, const auto& b) { return a.time_h < b.time_h; });
    values = table::DayValues(fields, grid);
  }
};

SkyPlanner::SkyPlanner(const SkyFile& file, base::Progress progress) : file_(file), progress_(std::move(progress)) {}
SkyPlanner::~SkyPlanner() = default;

SkyPlan SkyPlanner::plan(double aim) {
  SkyPlan plan;
  planTable(aim, plan);
  return finished(std::move(plan));
}

SkyPlan SkyPlanner::planWith(table::DayPlan table) {
  SkyPlan plan;
  take(std::move(table), plan);
  return finished(std::move(plan));
}

SkyPlan SkyPlanner::finished(SkyPlan plan) {
  if (file_.bake.mildest_window) plan.window_strength = applyMildestWindow(plan.table);
  plan.table_bytes = table::bytesOf(plan.representation, plan.table, plan.encoding);
  planCubemaps(plan);
  planGradients(plan);
  plan.left_out = leftOut(file_, plan);
  return plan;
}

double SkyPlanner::brightest() {
  if (!brightest_) brightest_ = table::brightestOf(file_.sky);
  return *brightest_;
}

void SkyPlanner::lookAt(std::vector<double> time_h) {
  std::sort(time_h.begin(), time_h.end());
  day_->add(time_h, brightest(), progress_.stage("plan", time_h.size()), ruleFor(file_));
}

void SkyPlanner::checkSettings() const {
  const BakeSettings& bake = file_.bake;
  if (bake.mildest_window && bake.reconstruction == table::Reconstruction::modes)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: bake.window = 'mildest': must be \"off\" with modes: it is one of coefficients",
                                  file_.inputs.front().path.string()));
  if (!bake.max_error && bake.reconstruction == table::Reconstruction::modes)
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{}: bake.reconstruction = \"modes\" needs a budget, max_error or --quality: it says how many",
                    file_.inputs.front().path.string()));
  checkTarget(file_);
}

void SkyPlanner::sample() {
  if (day_) return;
  const BakeSettings& bake = file_.bake;
  const double step_h = bake.max_error ? samplingStep_h(*bake.max_error) : format::kDay_h;
  day_ = std::make_unique<Day>(file_, step_h, brightest(), progress_.stage("plan", instantsFor(file_, step_h).size()));
}

table::FamilyMember SkyPlanner::member(double aim) {
  const BakeSettings& bake = file_.bake;
  checkSettings();
  sample();
  table::PlanRequest request;
  request.max_error = aim;
  if (bake.fixed.bands) request.bands = bake.bands;
  if (bake.fixed.reconstruction) request.reconstruction = bake.reconstruction;
  if (bake.mildest_window) request.reconstruction = table::Reconstruction::projected;
  request.sh_bands = bake.target.sh_bands;
  if (bake.fixed.encoding) request.encoding = bake.encoding;
  if (bake.fixed.keys) request.key_time_h = bake.key_time_h;
  return {&day_->values, std::move(request)};
}

void SkyPlanner::take(table::DayPlan day, SkyPlan& plan) const {
  const BakeSettings& bake = file_.bake;
  if (!day.met && day.predicted_error > *bake.max_error)
    throw cannotMeet(file_, "max_error", *bake.max_error,
                     fmt::format("the least error of the irradiance is {}, by {}, {} keys and {} numbers: "
                                 "{} bytes{}",
                                 leastText(day.predicted_error), day.representation.name(), day.table.key_time_h.size(),
                                 nameOf(day.encoding), day.bytes,
                                 bake.target.sh_bands == 0
                                     ? ""
                                     : fmt::format("; target = \"{}\" reads no more than {} bands; modes hold less "
                                                   "error: --target modes, and shaders/welkin/modes.glsl in the game",
                                                   bake.target.name, bake.target.sh_bands)));
  plan.representation = std::move(day.representation);
  plan.table = std::move(day.table);
  plan.encoding = day.encoding;
  plan.quadrature.circles = &ruleFor(file_);
  plan.predicted_error = day.predicted_error;
  plan.considered = std::move(day.considered);
}

void SkyPlanner::planTable(double aim, SkyPlan& plan) {
  if (!file_.bake.max_error) return planWithoutBudget(plan);
  const table::FamilyMember request = member(aim);
  take(table::planDay(*request.day, request.request, progress_), plan);
}

void SkyPlanner::planWithoutBudget(SkyPlan& plan) {
  const BakeSettings& bake = file_.bake;
  checkSettings();
  const bool fits = bake.reconstruction != table::Reconstruction::projected;
  if (fits) sample();
  plan.table =
      table::bakeDayTable(file_.sky, bake.bands, bake.key_time_h, progress_.stage("table", bake.key_time_h.size()));
  plan.encoding = bake.encoding;
  plan.representation.bands = bake.bands;
  plan.representation.fitted = fits;
  if (!fits) return;
  const auto& hours = day_->fields.instant;
  std::vector<std::size_t> keys;
  for (std::size_t i = 0; i < hours.size(); ++i)
    if (std::binary_search(bake.key_time_h.begin(), bake.key_time_h.end(), hours[i].time_h)) keys.push_back(i);
  plan.table = table::tableAt(day_->values, table::coefficientsOf(day_->values, bake.bands, true), keys);
  plan.quadrature.circles = &ruleFor(file_);
}

void SkyPlanner::planCubemaps(SkyPlan& plan) {
  const BakeSettings& bake = file_.bake;
  plan.cubemap_size = bake.cubemap_time_h.empty() ? 0 : bake.cubemap_size;
  plan.cubemap_format = bake.cubemap_format;
  plan.cubemap_time_h = bake.cubemap_time_h;
  const std::optional<double> budget = bake.cubemap_error ? bake.cubemap_error : bake.max_error;
  if (budget && !bake.fixed.cubemaps) {
    cubemap::CubemapLimits limits;
    if (!bake.cubemap_error) limits.most_bytes = kCubemapBytes;
    if (!cubemaps_) cubemaps_ = cubemap::planCubemaps(file_.sky, *budget, limits, progress_.stage("cubemap plan", 0));
    if (!cubemaps_->met && bake.cubemap_error)
      throw cannotMeet(
          file_, "cubemap_error", *budget,
          fmt::format("{}; that is {} cubemaps of {} in {}: {:.0f} bytes; cubemap_size = 0 leaves them out",
                      cubemaps_->reason, cubemaps_->time_h.size(), cubemaps_->size, format::nameOf(cubemaps_->format),
                      cubemaps_->bytes));
    plan.cubemap_size = cubemaps_->size;
    plan.cubemap_format = cubemaps_->format;
    plan.cubemap_time_h = cubemaps_->time_h;
    plan.cubemap_error = cubemaps_->measured.error;
    if (!cubemaps_->met) plan.warnings.push_back(shortOf(*cubemaps_, *budget));
  }
  plan.cubemap_bytes = format::bytesOfCubemaps(plan.cubemap_format, static_cast<std::uint64_t>(plan.cubemap_size),
                                               plan.cubemap_time_h.size());
  if (static_cast<double>(plan.cubemap_bytes) > kCubemapBytes) plan.warnings.push_back(largeCubemaps(plan));
}

void SkyPlanner::planGradients(SkyPlan& plan) {
  const BakeSettings& bake = file_.bake;
  const auto errorOf = [&](model::GradientFormat format) {
    return cubemap::measureGradients(file_.sky, format, cubemap::Effort::fast).error;
  };
  plan.gradient_format = bake.gradient_format;
  if (bake.max_error && !bake.fixed.gradients) {
    if (!dome_error_) dome_error_ = errorOf(model::GradientFormat::rgb9e5);
    if (*dome_error_ <= *bake.max_error) plan.gradient_format = model::GradientFormat::rgb9e5;
  }
  const bool is_small = plan.gradient_format == model::GradientFormat::rgb9e5;
  if (is_small && !dome_error_) dome_error_ = errorOf(plan.gradient_format);
  plan.dome_error = is_small ? *dome_error_ : 0.0;
  if (bake.max_error && plan.dome_error > *bake.max_error)
    throw cannotMeet(file_, "max_error", *bake.max_error,
                     fmt::format("gradient_format = \"rgb9e5\" makes an error of the dome of {:.3g}; \"rgb32f\" "
                                 "makes none",
                                 plan.dome_error));
  plan.gradient_bytes =
      (is_small ? 4 : 12) * (file_.sky.gradient_sun.rgb.size() + file_.sky.gradient_anti.rgb.size()) / 3;
}

}  // namespace welkin::bake
