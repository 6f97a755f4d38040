// SPDX-License-Identifier: Apache-2.0
// An opened sky: the memory of its file and the table inside it.
#pragma once

#include <welkin/welkin.h>

#include <cstddef>
#include <optional>
#include <span>

#include "core/arguments.h"
#include "core/day.h"
#include "core/light.h"
#include "core/open_file.h"
#include "format/container.h"
#include "format/domain_check.h"
#include "shared.h"

namespace welkin::core {

/// WELKIN_OK if everything that sampling reads is there and in its domain. Otherwise WELKIN_ERROR_CONTENT, and
/// `message` names the value. `bytes`: the size of the whole file.
WelkinResult checkContent(const format::File& file, std::size_t bytes, WelkinMessage* message);

using format::spanOf;

inline f64::LuminanceModel luminanceModel(const format::Luminance& l) {
  return {l.a(), l.b(), l.c(), l.d(), l.e(), l.k()};
}

/// Degree l of the coefficient at an index.
constexpr int bandOf(std::uint32_t coefficient) {
  return coefficient < 1 ? 0 : coefficient < 4 ? 1 : coefficient < 9 ? 2 : coefficient < 16 ? 3 : 4;
}

/// Least divisor. It is above 0 as a float, too.
inline constexpr double kLeastDivisor = 1e-30;

}  // namespace welkin::core

struct WelkinSky {
  welkin::core::FileBytes source;
  const welkin::format::File* file = nullptr;  ///< checked by checkContent; points into the map or the caller's bytes
  welkin::core::Curve intensity, ambient_saturation, polarising_tint;
  welkin::core::Light sun;
  std::optional<welkin::core::Light> moon;
  welkin::f64::LuminanceModel luminance{};
  bool normalise_to_sun = false;
  welkin::f64::Number3 albedo;
  welkin::core::Day day;
  welkin::core::PolarFrame frame;
  std::size_t cubemap_count = 0;
  welkin::core::HostArray<double> cubemap_time_h;
  welkin::core::HostArray<float> gradient_sun, gradient_anti;  ///< decoded; null if the file holds floats
  double constant_norm = 1.0;                                  ///< f64::constantNorm of the luminance
  double ground_sh[25] = {};                                   ///< coefficients of a radiance of 1 below the horizon
};
