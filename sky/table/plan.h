// SPDX-License-Identifier: Apache-2.0
// What a bake of the day's table needs for an error that someone has stated: the fewest bytes, then the least work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sky/table/key_placement.h"

namespace welkin::table {

/// What is asked for, and what the sky file fixes.
struct PlanRequest {
  double max_error = 0.01;  ///< of the irradiance; docs/conventions.md
  std::optional<int> bands;
  std::optional<Reconstruction> reconstruction;
  std::optional<Encoding> encoding;
  std::vector<double> key_time_h;  ///< fixed keys; none: wherever they are needed
};

/// One of the ways that were looked at.
struct PlanChoice {
  std::string name;
  double error = 0.0;     ///< at keys, about: what no number of keys betters
  std::size_t keys = 0;   ///< with which it was the best for a while; 0: never was
  std::size_t bytes = 0;  ///< then
};

struct DayPlan {
  bool met = false;  ///< predicted_error <= max_error; else the best that can be had
  Representation representation;
  DayTable table;
  Encoding encoding = Encoding::float32;
  double predicted_error = 0.0;
  std::size_t bytes = 0;  ///< of table and modes
  std::vector<PlanChoice> considered;
};

/// Bytes of a table as it is stored, with its modes.
std::size_t bytesOf(const Representation& r, const DayTable& table, Encoding encoding);

/// The same plan for any number of threads. `progress` is asked now and then, and may stop it, as in bakeDayTable.
DayPlan planDay(const DayValues& day, const PlanRequest& request, const Progress& progress = {});

}  // namespace welkin::table
