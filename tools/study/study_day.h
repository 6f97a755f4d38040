// SPDX-License-Identifier: Apache-2.0
// The day that a study measures, sampled once for all axes, and the representations of it that are compared.
#pragma once

#include <string>
#include <vector>

#include "sky/bake/sky_file.h"
#include "sky/table/representation.h"

namespace welkin::study {

/// The extent of a study, and its listeners.
struct StudyOptions {
  bool quick = false;            ///< fewer instants, candidates and cubemaps
  base::Progress progress = {};  ///< steps after every axis
  int sh_bands = 0;              ///< bands of SH that the light's reader can use, of bake::Target; 0: modes and all
};

/// Irradiance at every few minutes and wherever the sun's path bends. Neither copied nor moved: parts point at others.
class StudyDay {
 public:
  StudyDay(const model::Sky& sky, double step_h, const base::Progress& progress);
  StudyDay(const StudyDay&) = delete;
  StudyDay& operator=(const StudyDay&) = delete;

  const model::Sky& sky() const { return *fields_.sky; }
  const table::DayFields& fields() const { return fields_; }
  const table::DayValues& values() const { return values_; }
  const table::ErrorGrid& grid() const { return grid_; }
  std::size_t count() const { return fields_.instant.size(); }

 private:
  table::ErrorGrid grid_;
  table::DayFields fields_;
  table::DayValues values_;
};

/// The way to find the numbers of a representation.
enum class Fit {
  projected,  ///< coefficients of the radiance; of modes, the nearest combination in the mean square
  fitted,     ///< the least largest error of the irradiance
  windowed    ///< projected, then the mildest window that keeps irradiance from being negative (sh/window.h)
};

/// A representation of the day's irradiance that the study compares with others.
struct Candidate {
  std::string name;
  table::Representation representation;
  Fit fit = Fit::projected;
  double window_strength = 0.0;
  double error = 0.0;  ///< the largest at exact keys: by the part left out, and by the map of modes

  bool isModes() const { return representation.modes.has_value(); }
  /// Numbers a channel and instant that irradiance depends on; the ground's horizontal irradiance apart.
  std::size_t numbers() const;
  /// Bytes of a key and of everything else in a table, as table::bytesOf counts them.
  std::size_t bytesOfKey(const model::Sky& sky, table::Encoding encoding) const;
  std::size_t bytes(const model::Sky& sky, std::size_t keys, table::Encoding encoding) const;
};

Candidate bandsCandidate(const StudyDay& day, int bands, Fit fit);

/// Texels of a map of modes.
struct MapSize {
  int columns, rows;
};
inline constexpr MapSize kSmallMap = {9, 5}, kMiddleMap = {9, 9}, kLargeMap = {17, 17}, kLargestMap = {25, 25};

/// Modes and the weights nearest to every instant. Maps of any size share them.
struct DayWeights {
  table::ModeSet set;
  std::vector<det::Number3> weights;
};
DayWeights modeWeights(const StudyDay& day, const table::DayModes& modes, std::size_t count);
Candidate modesCandidate(const StudyDay& day, const DayWeights& modes, MapSize map, Fit fit);

/// The largest error over the instants when every one is a key.
double errorAtKeys(const StudyDay& day, const table::Representation& r);

}  // namespace welkin::study
