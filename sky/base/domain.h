// SPDX-License-Identifier: Apache-2.0
// The domain of a file's parameters: kind, unit, range and default of each, and the consequence of a value outside. The
// loader, the table in the docs and the sweeps in the tests all use it.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace welkin::base {

/// Interval of numbers, closed unless its high end is left out. Never holds NaN.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool without_high = false;

  bool contains(double value) const { return value >= low && (without_high ? value < high : value <= high); }
};

/// How a value is written.
enum class Kind {
  number,
  whole_number,
  word,            ///< one of Parameter::words
  colour,          ///< [r, g, b]
  number_or_keys,  ///< a number, or [[time_h, number], ...]
  colour_or_keys,
  gradient,   ///< a colour, or the name of an image
  tint,       ///< a colour, keys, or the name of an image
  luminance,  ///< one of Parameter::words, or five coefficients, the parts
  path,       ///< [[time_h, azimuth_deg, elevation_deg], ...], the parts
  hours,      ///< a number of evenly spread hours, a list of hours, or one of Parameter::words
  image,      ///< the name of an image
  file,       ///< the name of a file
  names,      ///< a list of names
  vector,     ///< [x, y, z]
  number_or_vector,
  points,   ///< [[x, y, z], ...]
  box,      ///< [min_x, min_y, min_z, max_x, max_y, max_z]
  boxes,    ///< a list of boxes
  sectors,  ///< true, false, a list of sectors, or one of Parameter::words
  part      ///< a number within another key's list
};

/// The key must be there, unless its meaning names a substitute.
struct Required {};
/// The default of an absent key: a number (for a colour, of every component), a word, or words that say where the value
/// comes from.
using Default = std::variant<Required, double, std::string_view>;

struct Parameter {
  std::string_view section;  ///< as in [section]; empty: any section
  std::string_view key;
  std::string_view part;  ///< which part, for Kind::part
  Kind kind = Kind::number;
  std::string_view unit;  ///< empty: none
  Range range;            ///< range of every number in the value; for a list of hours, of their count
  Default otherwise = Required{};
  std::string_view meaning;  ///< meaning and further conditions
  std::string_view outside = "refused";
  std::vector<std::string_view> words = {};
  bool without_path = false;  ///< not allowed beside the section's path
};

using Domain = std::vector<Parameter>;

/// Returns the row of a key, or of a part of it. The row must exist.
const Parameter& parameterOf(const Domain& rows, std::string_view section, std::string_view key,
                             std::string_view part = "");

/// Returns the table for a page of the docs: Markdown, one line for each parameter.
std::string domainTable(const Domain& rows);

}  // namespace welkin::base
