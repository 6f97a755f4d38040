// SPDX-License-Identifier: Apache-2.0
// The domain of a file's parameters: kind, unit, range and default of each, and the consequence of a value outside. A
// loader takes its ranges from here, a page of docs its table, and tests their sweeps.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace welkin::base {

/// Interval of numbers, closed unless an end is left out; never holds NaN.
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
  hours,      ///< a whole number of hours spread evenly, a list of hours, or one of Parameter::words
  image,      ///< the name of an image
  file,       ///< the name of a file
  names,      ///< a list of names
  vector,     ///< [x, y, z]
  number_or_vector,
  points,   ///< [[x, y, z], ...]
  box,      ///< [min_x, min_y, min_z, max_x, max_y, max_z]
  boxes,    ///< a list of those
  sectors,  ///< true, false, a list of sectors, or one of Parameter::words
  part      ///< a number within another key's list
};

/// A key that must be there, unless the meaning says what may stand in its place.
struct Required {};
/// What stands for an absent key: a number (of a colour: of each component), a word, or words that say where it comes
/// from.
using Default = std::variant<Required, double, std::string_view>;

struct Parameter {
  std::string_view section;  ///< as in [section]; empty: in any
  std::string_view key;
  std::string_view part;  ///< of Kind::part: which
  Kind kind = Kind::number;
  std::string_view unit;  ///< empty: none
  Range range;            ///< of every number in the value; of a list of hours, of their count
  Default otherwise = Required{};
  std::string_view meaning;  ///< and further conditions
  std::string_view outside = "refused";
  std::vector<std::string_view> words = {};
  bool without_path = false;  ///< cannot stand beside the section's path
};

using Domain = std::vector<Parameter>;

/// The row of a key, or of a part of it. There must be one.
const Parameter& parameterOf(const Domain& rows, std::string_view section, std::string_view key,
                             std::string_view part = "");

/// The table of a page: Markdown, a line a parameter.
std::string domainTable(const Domain& rows);

}  // namespace welkin::base
