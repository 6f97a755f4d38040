// SPDX-License-Identifier: Apache-2.0
// The day's table: the shape of the sky's radiance at every key, in the frame of the sun's azimuth.
#pragma once

#include <functional>
#include <optional>

#include "sky/base/progress.h"
#include "sky/model/projection.h"

namespace welkin::table {

/// How irradiance follows from the table's rows: coefficients of the radiance, coefficients fitted to the irradiance,
/// or weights of modes.
enum class Reconstruction { projected, fitted, modes };
const char* nameOf(Reconstruction reconstruction);

/// Modes of the irradiance as a file holds them: table Modes in runtime/format/welkin.fbs.
struct ModeTable {
  int count = 0;  ///< 1..12
  int columns = 0;
  int rows = 0;
  std::vector<std::uint16_t> texels;  ///< halfs, by row, column, mode
  std::vector<float> polar_sh;        ///< radiance, by mode and coefficient
};

/// Computed numbers before encoding. With modes the rows are their weights. Without modes they are the coefficients of
/// m >= 0 (polarIndex), and the horizontal irradiance where the ground is not black.
struct DayTable {
  int bands = 2;
  int channels = 3;  ///< 1 for a grey sky, whose three channels are equal
  int rows = 0;
  std::vector<double> key_time_h;
  std::vector<double> number;  ///< by key, row, channel
  std::optional<ModeTable> modes;
  std::size_t evaluations = 0;  ///< number of evaluations of the sky's radiance

  std::size_t numbersOfKey() const { return static_cast<std::size_t>(rows * channels); }
};

/// Whether the sky is grey at all times.
bool isGrey(const model::Sky& sky);

/// Whether the ground reflects, so that a file of this sky needs the horizontal irradiance.
bool hasGround(const model::Sky& sky);

/// Projects every key within `tolerance` (projection.h) into `bands` bands, in parallel (oneTBB's current arena). The
/// bytes are the same for any number of threads.
DayTable bakeDayTable(const model::Sky& sky, int bands, const std::vector<double>& key_time_h,
                      const base::Progress& progress, double tolerance = model::kTolerance);

}  // namespace welkin::table
