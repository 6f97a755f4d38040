// SPDX-License-Identifier: Apache-2.0
// The [bake] section of sky.toml: the products of a bake, and the choices left to a budget.
#pragma once

#include <optional>
#include <vector>

#include "format/cubemap_format.h"
#include "sky/base/section.h"
#include "sky/table/day_encoding.h"

namespace welkin::bake {

/// The [bake] section. Absent settings have the values of a bake without a budget.
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

  /// Settings that the file states itself. A budget keeps them and chooses the rest.
  struct Fixed {
    bool bands = false, keys = false, cubemaps = false, gradients = false, reconstruction = false, encoding = false;
  } fixed = {};
};

/// Number of keys of a table with keys = "auto": one every five minutes.
inline constexpr int kAutoKeys = 288;

/// Reads the section. Throws Error(content).
BakeSettings readBake(base::Section section);

}  // namespace welkin::bake
