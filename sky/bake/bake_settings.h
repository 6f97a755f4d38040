// SPDX-License-Identifier: Apache-2.0
// The [bake] section of sky.toml: the products of a bake, and the choices left to a budget.
#pragma once

#include <optional>
#include <vector>

#include "format/cubemap_format.h"
#include "sky/base/section.h"
#include "sky/table/day_encoding.h"

namespace welkin::bake {

/// The named budgets, fractions: draft 10 %, preview 3 %, final 1 %.
struct Quality {
  const char* name;
  double max_error;
};
inline constexpr Quality kDefaultQuality = {"preview", 0.03};  ///< of a section that states nothing
inline constexpr Quality kQualities[] = {{"draft", 0.1}, kDefaultQuality, {"final", 0.01}};

/// The budget of a name. Throws Error(usage) for any other name.
double errorOf(const std::string& quality);

/// Readers of the ambient light, by the bands of SH that they can use. 0: modes, or any bands.
struct Target {
  const char* name;
  int sh_bands;
};
inline constexpr Target kTargets[] = {{"modes", 0}, {"sh2", 2},   {"sh3", 3},    {"filament", 3},
                                      {"three", 3}, {"unity", 3}, {"unreal", 3}, {"godot", 3}};

/// The [bake] section. Absent settings have the values of a bake without a budget. A section that states none of them
/// has the budget kDefaultQuality.
struct BakeSettings {
  int bands = 2;
  std::vector<double> key_time_h;
  int cubemap_size = 128;  ///< 0: none
  std::vector<double> cubemap_time_h;
  format::CubemapFormat cubemap_format = format::CubemapFormat::rgba16f;
  model::GradientFormat gradient_format = model::GradientFormat::rgb32f;
  table::Reconstruction reconstruction = table::Reconstruction::projected;
  table::Encoding encoding = table::Encoding::float32;
  bool mildest_window = false;
  std::optional<double> max_error = std::nullopt;  ///< absent: no budget, and the settings apply as they stand here
  /// Budget of the cubemaps alone. Absent: max_error, as far as kCubemapBytes go.
  std::optional<double> cubemap_error = std::nullopt;
  Target target = kTargets[0];  ///< the bake's light is what this reader can use of it

  /// Settings that the file states itself. A budget keeps them and chooses the rest.
  struct Fixed {
    bool bands = false, keys = false, cubemaps = false, gradients = false, reconstruction = false, encoding = false;
  } fixed = {};
};

/// Most bytes of the cubemaps under a budget that is not stated for them. A plan warns of more.
inline constexpr double kCubemapBytes = 64e6;

/// Number of keys of a table with keys = "auto": one every five minutes.
inline constexpr int kAutoKeys = 288;

/// Takes the target of a name. Throws Error(usage) for any other name.
void setTarget(BakeSettings& bake, const std::string& name);

/// Takes a budget for the cubemaps in place of the section's settings of them. 0: no cubemaps.
void setCubemapError(BakeSettings& bake, double cubemap_error);

/// Reads the section. Throws Error(content).
BakeSettings readBake(base::Section section);

}  // namespace welkin::bake
