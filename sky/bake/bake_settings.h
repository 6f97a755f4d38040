// SPDX-License-Identifier: Apache-2.0
// The [bake] section of sky.toml: what a bake makes, and what it leaves to a budget.
#pragma once

#include <optional>
#include <vector>

#include "format/cubemap_format.h"
#include "sky/base/section.h"
#include "sky/table/day_encoding.h"

namespace welkin::bake {

/// The [bake] section. What the file leaves open has the value of a bake without a budget.
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
  std::optional<double> max_error = std::nullopt;  ///< none: no budget, and everything is as it stands here

  /// What the file says itself, which a budget keeps; it chooses the rest.
  struct Fixed {
    bool bands = false, keys = false, cubemaps = false, gradients = false, reconstruction = false, encoding = false;
  } fixed = {};
};

/// Keys of a table with keys = "auto": one every five minutes.
inline constexpr int kAutoKeys = 288;

/// Throws Error(content).
BakeSettings readBake(base::Section section);

}  // namespace welkin::bake
