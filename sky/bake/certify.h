// SPDX-License-Identifier: Apache-2.0
// The certificate: the irradiance error of a baked sky, measured through the runtime that a game links.
#pragma once

#include <welkin/welkin.h>

#include "sky/table/key_placement.h"

namespace welkin::bake {

enum class Certify { none, fast, full };

/// "none", "fast" or "full".
const char* nameOf(Certify certify);

inline constexpr double kMinute_h = 1.0 / 60.0;

/// The result of a bake, as the certificate needs it.
struct Baked {
  const model::Sky& sky;
  const table::Representation& representation;
  const table::DayTable& table;
  table::Encoding encoding;
  model::Quadrature quadrature;
  double brightest;              ///< table::brightestOf the sky
  double window_strength = 0.0;  ///< of the window on the table's coefficients (sh/window.h)
};

/// The hours that a certificate looks at: every `step_h`, the keys, the middle between two keys, and where the sun's
/// path bends. Ascending.
std::vector<double> instantsOf(const model::Sky& sky, const table::DayTable& table, double step_h);

/// Measures `opened`, the file of `baked`, at instantsOf the day. `fast` compares with the sky's irradiance at 884
/// normals on both sides of the sun's plane (sky/model/irradiance.h). `full` adds direct integration
/// (sky/model/projection.h, 1e-5) at 642 evenly spread normals, which takes minutes. The numbers are the same for any
/// number of threads. Throws Error(interrupted).
table::Certificate certify(const WelkinSky* opened, const Baked& baked, Certify how, const base::Progress& progress,
                           double step_h = kMinute_h);

/// Number of progress steps of certify.
std::size_t certifySteps(const Baked& baked, Certify how);

}  // namespace welkin::bake
