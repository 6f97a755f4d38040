// SPDX-License-Identifier: Apache-2.0
// Plans the day's table for a stated error: the fewest bytes, then the least work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sky/table/key_placement.h"

namespace welkin::table {

/// Modes that a table must weigh, and the size of their map: those that the skies of a family share.
struct SharedModes {
  const ModeSet* set = nullptr;  ///< must outlive the plan
  int columns = 0, rows = 0;
};

/// The request, and the choices that the sky file fixes.
struct PlanRequest {
  double max_error = 0.01;  ///< of the irradiance; docs/conventions.md
  std::optional<int> bands;
  std::optional<Reconstruction> reconstruction;
  int sh_bands = 0;  ///< bands of SH that are all the light's reader can use; 0: it reads modes and any bands
  std::optional<Encoding> encoding;
  std::vector<double> key_time_h;     ///< fixed keys; empty: keys go where they are needed
  std::optional<SharedModes> shared;  ///< in place of everything that a plan may choose but keys and encoding
};

/// One of the ways that were tried.
struct PlanChoice {
  std::string name;
  double error = 0.0;     ///< approximate error at the keys; more keys cannot lower it
  std::size_t keys = 0;   ///< number of keys when this way led; 0 if it never did
  std::size_t bytes = 0;  ///< bytes at that time
};

struct DayPlan {
  bool met = false;  ///< predicted_error <= max_error; if false, this is the best available plan
  Representation representation;
  DayTable table;
  Encoding encoding = Encoding::float32;
  double predicted_error = 0.0;
  std::size_t bytes = 0;  ///< bytes of table and modes
  std::vector<PlanChoice> considered;
};

/// Sizes of modes' maps to try, in order of growing bytes.
struct MapSize {
  int columns, rows;
};
inline constexpr MapSize kMaps[] = {{5, 3},  {5, 5},   {9, 5},   {9, 7},   {9, 9},
                                    {9, 13}, {13, 13}, {17, 17}, {17, 25}, {25, 25}};

/// Largest gain expected of a minimax fit. A fit costs 0.2 s a day, so only tables this close are fitted.
inline constexpr double kWorthFitting = 1.7;

inline constexpr int kFallbackBands = 3;  ///< bands of the samples beside modes, unless the file says

/// The largest error of every fourth instant when it is a key: a first look at a representation.
double errorAtKeys(const DayValues& day, const Representation& r);

/// Bytes of a table as it is stored, modes included.
std::size_t bytesOf(const Representation& r, const DayTable& table, Encoding encoding);

/// The plan is the same for any number of threads. `progress` is called now and then and may stop it, as in
/// bakeDayTable.
DayPlan planDay(const DayValues& day, const PlanRequest& request, const base::Progress& progress = {});

}  // namespace welkin::table
