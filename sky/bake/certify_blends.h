// SPDX-License-Identifier: Apache-2.0
// The certificate of a family's cross-blends, measured through the runtime that a game links.
#pragma once

#include <span>
#include <vector>

#include "sky/bake/certify.h"

namespace welkin::bake {

/// A sky of a family, as it was baked.
struct FamilySky {
  const WelkinSky* opened;
  const model::Sky& sky;
  const table::DayTable& table;
};

/// The largest error of the blends of two skies.
struct BlendError {
  std::size_t first = 0, second = 0;  ///< indices of the skies
  double weight = 0.0;                ///< of the second
  double max_error = 0.0;             ///< as Certificate::max_error, of the mean of both models' irradiance
  double time_h = 0.0;                ///< time, normal and channel of max_error
  det::Number3 normal{0.0, 1.0, 0.0};
  int channel = 0;
  std::vector<table::Certificate::At> day;  ///< largest error at every instant, in the order of time
};

/// Hours between the instants that are looked at, beside those that instantsOf adds.
inline constexpr double kBlendStep_h = 1.0 / 12.0;

/// Blends every two skies by welkin_sample_blend, at 1/4, 1/2 and 3/4, and compares welkin_sky_irradiance with the mean
/// of the models' own irradiance at 884 normals, at instantsOf both skies. By pair, in the order of the skies. The
/// numbers are the same for any number of threads. Throws Error(interrupted); Error(internal) where the runtime refuses
/// the blend.
std::vector<BlendError> certifyBlends(std::span<const FamilySky> family, const base::Progress& progress,
                                      double step_h = kBlendStep_h);

}  // namespace welkin::bake
