// SPDX-License-Identifier: Apache-2.0
// The day's table: the shape of the sky's radiance at every key, in the frame of the sun's azimuth.
#pragma once

#include <functional>
#include <optional>

#include "sky/model/projection.h"

namespace welkin::table {

/// How irradiance is made of the table's rows: coefficients of the radiance, coefficients fitted to the irradiance, or
/// weights of modes.
enum class Reconstruction { projected, fitted, modes };
const char* nameOf(Reconstruction reconstruction);

/// Modes of the irradiance as a file holds them: runtime/format/welkin.fbs, table Modes.
struct ModeTable {
  int count = 0;  ///< 1..12
  int columns = 0;
  int rows = 0;
  std::vector<std::uint16_t> texels;  ///< halfs: row, column, mode
  std::vector<float> polar_sh;        ///< mode, coefficient: radiance
};

/// Numbers as computed, before they are encoded. With modes the rows are their weights; without, the coefficients of
/// m >= 0 (polarIndex), and the horizontal irradiance where the ground is not black.
struct DayTable {
  int bands = 2;
  int channels = 3;  ///< 1 for a grey sky: all three would be the same
  int rows = 0;
  std::vector<double> key_time_h;
  std::vector<double> number;  ///< key, row, channel
  std::optional<ModeTable> modes;
  std::size_t evaluations = 0;  ///< of the sky's radiance

  std::size_t numbersOfKey() const { return static_cast<std::size_t>(rows * channels); }
};

/// Told after every finished piece of work, from any thread; returns false to stop, which throws Error(interrupted).
using Progress = std::function<bool()>;

/// Whether the sky has no hue at all, at any time.
bool isGrey(const model::Sky& sky);

/// Whether a file of this sky needs the horizontal irradiance: its ground reflects.
bool hasGround(const model::Sky& sky);

/// Projects every key within `tolerance` (projection.h) into `bands` bands, in parallel (oneTBB's current arena); the
/// same bytes for any number of threads.
DayTable bakeDayTable(const model::Sky& sky, int bands, const std::vector<double>& key_time_h, const Progress& progress,
                      double tolerance = model::kTolerance);

}  // namespace welkin::table
