// SPDX-License-Identifier: Apache-2.0
// The second axis of a study: the number of keys in a day, their placement, and interpolation between them.
#pragma once

#include "study/report.h"
#include "study/runtime_speed.h"

namespace welkin::study {

/// Keys of one candidate for one error.
struct KeyCounts {
  std::string representation;
  double max_error = 0.0;
  std::size_t placed = 0;    ///< table::placeKeys, linear
  std::size_t hermite = 0;   ///< the most favourable cubic: cubic_time.h
  double catmull_rom = 0.0;  ///< error of Catmull-Rom at the placed keys
};

/// Even keys of one candidate.
struct EvenKeys {
  std::string representation;
  std::size_t keys = 0;
  double linear = 0.0;       ///< error
  double catmull_rom = 0.0;  ///< error
};

struct KeyStudy {
  std::vector<KeyCounts> counts;
  std::vector<EvenKeys> even;
};

KeyStudy measureKeys(const StudyDay& day, const std::vector<Candidate>& candidates, const StudyOptions& options);

/// Adds the tables "keys_even" and "keys_placed" and the chart "keys".
void reportKeys(const KeyStudy& keys, StudyReport& report);

}  // namespace welkin::study
