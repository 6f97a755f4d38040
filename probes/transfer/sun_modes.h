// SPDX-License-Identifier: Apache-2.0
// The transfer of the sun and the moon along their own paths, of low rank in time: a few functions of time that a
// sector shares, and a few coefficients per probe, direction and channel. One set of coefficients serves both lights.
#pragma once

#include <span>
#include <vector>

#include "probes/transfer/light_track.h"
#include "probes/transfer/transfer.h"

namespace welkin::probes {

inline constexpr std::size_t kMostSunModes = 8;

enum class LightOf { sun, moon };

/// Modes of time, orthonormal over the knots, the most energetic first.
struct SunModes {
  std::vector<double> sun_time_h;   ///< knots, ascending in [0, 24)
  std::vector<double> moon_time_h;  ///< likewise; none: no moon
  std::vector<double> value;        ///< [mode][knot], the sun's knots first

  std::size_t knots() const { return sun_time_h.size() + moon_time_h.size(); }
  std::size_t count() const { return knots() == 0 ? 0 : value.size() / knots(); }
};

/// How far the transfers, rebuilt from the first n modes and clamped at 0, are from those that they were made of:
/// irradiance of a light of normal irradiance 1.
struct SunModesError {
  double rms = 0.0;        ///< over probes, directions, channels and knots
  double worst_row = 0.0;  ///< root of the mean square over the knots, of the worst probe, direction and channel
  double worst = 0.0;      ///< of one knot
};

struct SunModesFit {
  SunModes modes;
  /// Coefficients: [probe][direction][mode].
  std::vector<std::array<std::vector<Number3>, kDirections>> coefficient;
  std::vector<SunModesError> error;  ///< by number of modes, from 0
};

/// The `count` leading modes of the probes' ProbeTransfer::sun, of which the first knots are the sun's and the others
/// the moon's, or as many as there are. Deterministic.
SunModesFit fitSunModes(std::span<const ProbeTransfer* const> probes, const LightTrack& sun, const LightTrack& moon,
                        std::size_t count);

/// The fewest modes whose worst_row is at most `max_error`; all of them where none is.
std::size_t modesFor(const SunModesFit& fit, double max_error);

/// The first `count` modes and their coefficients.
SunModesFit firstModes(SunModesFit fit, std::size_t count);

/// The modes at a finite time for a light that is up: linear between knots. Empty without modes; 0 for a light without
/// knots.
std::vector<double> modesAt(const SunModes& modes, LightOf light, double time_h);

/// Irradiance of a light of normal irradiance 1 from coefficients and modes at a time, not below 0.
Number3 sunTransfer(std::span<const Number3> coefficient, std::span<const double> mode);

}  // namespace welkin::probes
