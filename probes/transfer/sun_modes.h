// SPDX-License-Identifier: Apache-2.0
// Low-rank transfer of the sun and the moon along their own paths. A sector shares a few coloured functions of time,
// and each probe has one number per function and direction. The numbers serve both lights.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "probes/transfer/light_track.h"
#include "probes/transfer/transfer.h"

namespace welkin::transfer {

using f64::Number3;

inline constexpr std::size_t kMostSunModes = 16;

enum class LightOf { sun, moon };

/// Modes of time and colour, orthonormal over knots and channels, the most energetic first.
struct SunModes {
  std::vector<double> sun_time_h;   ///< knots, ascending in [0, 24)
  std::vector<double> moon_time_h;  ///< knots of the moon; empty without a moon
  std::vector<Number3> value;       ///< [mode][knot], the sun's knots first

  std::size_t knots() const { return sun_time_h.size() + moon_time_h.size(); }
  std::size_t count() const { return knots() == 0 ? 0 : value.size() / knots(); }
};

/// A probe's coefficients of the modes: [direction][mode].
using SunCoefficients = std::array<std::vector<double>, kDirections>;

/// Error of the transfers that are rebuilt from the first n modes and clamped at 0. The unit is irradiance by a light
/// of normal irradiance 1.
struct SunModesError {
  double rms = 0.0;        ///< over probes, directions, knots and channels
  double worst_row = 0.0;  ///< root mean square over knots and channels for the worst probe and direction
  double worst = 0.0;      ///< largest error of one number
};

struct SunModesFit {
  SunModes modes;
  std::vector<SunCoefficients> coefficient;  ///< by probe
  std::vector<SunModesError> error;          ///< by number of modes, from 0
};

/// Finds the `count` leading modes of the probes' ProbeTransfer::sun, or as many as there are. The first knots are the
/// sun's and the others the moon's. Deterministic.
SunModesFit fitSunModes(std::span<const ProbeTransfer* const> probes, const LightTrack& sun, const LightTrack& moon,
                        std::size_t count);

/// The smallest number of modes whose worst_row is at most `max_error`, or all of them if there is none.
std::size_t modesFor(const SunModesFit& fit, double max_error);

/// The first `count` modes and their coefficients.
SunModesFit firstModes(SunModesFit fit, std::size_t count);

/// The modes at a finite time for a light that is up, linear between knots. The result is empty without modes, and 0
/// for a light without knots.
std::vector<Number3> modesAt(const SunModes& modes, LightOf light, double time_h);

/// Irradiance by a light of normal irradiance 1, from coefficients and as many modes at one time; not below 0.
Number3 sunTransfer(std::span<const double> coefficient, std::span<const Number3> mode);

}  // namespace welkin::transfer
