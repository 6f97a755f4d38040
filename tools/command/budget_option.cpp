// SPDX-License-Identifier: Apache-2.0
#include "command/budget_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

#include "probes/level/level_domain.h"
#include "sky/bake/sky_domain.h"
#include "sky/bake/sky_plan.h"

namespace welkin::command {
namespace {

/// Refuses a NaN, which CLI::Range accepts.
std::string notNan(const std::string& text) {
  return std::isnan(std::strtod(text.c_str(), nullptr)) ? "must be a number" : "";
}

/// Refuses all but "none" and a number in the domain of cubemap_error.
std::string notCubemaps(const std::string& text) {
  if (text == "none") return "";
  const base::Range& range = base::parameterOf(bake::skyDomain(), "bake", "cubemap_error").range;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0' && range.contains(value)) return "";
  return fmt::format("must be none or in {} to {}", range.low, range.high);
}

}  // namespace

void CubemapsOption::addTo(CLI::App& command) {
  command
      .add_option("--cubemaps", text,
                  "The largest error of the cubemaps, a fraction, in place of the file's settings of them; none: no "
                  "cubemaps")
      ->check(CLI::Validator(notCubemaps, ""));
}

std::optional<double> CubemapsOption::value() const {
  if (text.empty()) return std::nullopt;
  return text == "none" ? 0.0 : std::strtod(text.c_str(), nullptr);
}

void TargetOption::addTo(CLI::App& command) {
  std::vector<std::string> names;
  for (const bake::Target& target : bake::kTargets) names.emplace_back(target.name);
  command
      .add_option("--target", name,
                  "The reader of the ambient light; budget and certificate are of what it shows. modes: the game's own "
                  "shaders; sh2, sh3: 2 or 3 bands of SH; the engines take 3")
      ->check(CLI::IsMember(names));
}

void SurfaceBudgetOption::addTo(CLI::App& command) {
  const base::Range& range = base::parameterOf(level::levelDomain(), "bake", "max_surface_error").range;
  command
      .add_option("--max-surface-error", max_error,
                  "The largest rms error of a level's light on surfaces and in the air, a fraction of the open sky's; "
                  "every sector gets the probes that this takes")
      ->check(CLI::Range(range.low, range.high) & CLI::Validator(notNan, ""));
}

void BudgetOption::addTo(CLI::App& command) {
  const base::Range& range = base::parameterOf(bake::skyDomain(), "bake", "max_error").range;
  std::vector<std::string> names;
  std::string meaning = "A named budget:";
  for (const bake::Quality& q : bake::kQualities) {
    names.emplace_back(q.name);
    meaning +=
        fmt::format(" {} {:g} %{}", q.name, 100.0 * q.max_error, &q == std::end(bake::kQualities) - 1 ? "" : ",");
  }
  auto* error = command
                    .add_option("--max-error", max_error,
                                "The largest error that the bake may make, a fraction of the mean irradiance")
                    ->check(CLI::Range(range.low, range.high) & CLI::Validator(notNan, ""));
  command.add_option("--quality", quality, meaning)->check(CLI::IsMember(names))->excludes(error);
}

std::optional<double> BudgetOption::value() const {
  if (max_error > 0.0) return max_error;
  if (!quality.empty()) return bake::errorOf(quality);
  return std::nullopt;
}

}  // namespace welkin::command
