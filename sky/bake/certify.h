// SPDX-License-Identifier: Apache-2.0
// The certificate: the irradiance error that a baked sky really makes, measured through the runtime that a game links.
#pragma once

#include <welkin/welkin.h>

#include "sky/table/key_placement.h"

namespace welkin::bake {

enum class Certify { none, fast, full };

inline constexpr double kMinute_h = 1.0 / 60.0;

/// What was baked.
struct Baked {
  const model::Sky& sky;
  const table::Representation& representation;
  const table::DayTable& table;
  table::Encoding encoding;
  model::Quadrature quadrature;
};

/// Measures `opened`, the file of `baked`: at every minute of the day (every `step_h`), every key and the middle
/// between two, and the instants where the sun's path bends. `fast` compares with the sky's irradiance at 884 normals
/// on both sides of the sun's plane (sky/irradiance.h); `full` adds direct integration (sky/projection.h, 1e-5) at 642
/// evenly spread normals, which takes minutes. The same numbers for any number of threads. `progress` as in
/// bakeDayTable.
table::Certificate certify(const WelkinSky* opened, const Baked& baked, Certify how, const table::Progress& progress,
                           double step_h = kMinute_h);

/// How many steps of progress that takes.
std::size_t certifySteps(const Baked& baked, Certify how);

}  // namespace welkin::bake
