// SPDX-License-Identifier: Apache-2.0
#include "sky/base/domain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace welkin::base {
namespace {

std::string phrase(Kind kind) {
  switch (kind) {
    case Kind::number:
    case Kind::part:
      return "number";
    case Kind::whole_number:
      return "whole number";
    case Kind::word:
      return "word";
    case Kind::colour:
      return "colour";
    case Kind::number_or_keys:
      return "number or keys";
    case Kind::colour_or_keys:
      return "colour or keys";
    case Kind::gradient:
      return "image or colour";
    case Kind::tint:
      return "colour, keys or image";
    case Kind::luminance:
      return "name, or `[a, b, c, d, e]`";
    case Kind::path:
      return "`[[time_h, azimuth_deg, elevation_deg], ...]`";
    case Kind::hours:
      return "a number N (hours 24 i / N), or a list of hours";
    case Kind::image:
      return "image";
    case Kind::file:
      return "file";
    case Kind::names:
      return "a list of names";
    case Kind::vector:
      return "`[x, y, z]`";
    case Kind::number_or_vector:
      return "number or `[x, y, z]`";
    case Kind::points:
      return "`[[x, y, z], ...]`";
    case Kind::box:
      return "`[min_x, min_y, min_z, max_x, max_y, max_z]`";
    case Kind::boxes:
      return "`[[min_x, min_y, min_z, max_x, max_y, max_z], ...]`";
    case Kind::sectors:
      return "`true`, `false`, or a list of sectors, `[\"X_Z\", ...]`";
  }
  return {};
}

bool isColour(Kind kind) {
  return kind == Kind::colour || kind == Kind::colour_or_keys || kind == Kind::gradient || kind == Kind::tint;
}

std::string phrase(const Range& range) {
  if (range.low == range.high) return "";
  return fmt::format("{:g} to {}{:g}", range.low, range.without_high ? "below " : "", range.high);
}

std::string phraseDefault(const Parameter& p) {
  if (p.kind == Kind::part) return "";
  if (std::holds_alternative<Required>(p.otherwise)) return "required";
  if (const auto* word = std::get_if<std::string_view>(&p.otherwise))
    return p.words.empty() ? std::string(*word) : fmt::format("`{}`", *word);
  const double number = std::get<double>(p.otherwise);
  if (isColour(p.kind)) return number == 0.0 ? "black" : number == 1.0 ? "white" : fmt::format("{0}, {0}, {0}", number);
  return fmt::format("{}", number);
}

}  // namespace

const Parameter& parameterOf(const Domain& rows, std::string_view section, std::string_view key,
                             std::string_view part) {
  for (const Parameter& p : rows)
    if (p.section == section && p.key == key && p.part == part) return p;
  throw std::logic_error(fmt::format("no parameter {}.{} {}", section, key, part));
}

std::string domainTable(const Domain& rows) {
  std::string text = "| key | value | range | default | outside |\n|---|---|---|---|---|\n";
  std::string_view section;
  for (const Parameter& p : rows) {
    if (p.section != section) text += fmt::format("| **[{}]** | | | | |\n", section = p.section);
    std::string meaning(p.meaning);
    if (p.without_path) meaning += meaning.empty() ? "not beside `path`" : ", not beside `path`";
    const std::string range = phrase(p.range);
    text += fmt::format("| {}{}{} | {}{}{}{}{} | {}{}{} | {} | {} |\n", p.key, p.part.empty() ? "" : ": ", p.part,
                        phrase(p.kind), p.words.empty() ? "" : ", `", fmt::join(p.words, "`, `"),
                        p.words.empty() ? "" : "`", meaning.empty() ? "" : "; " + meaning, range,
                        range.empty() || p.unit.empty() ? "" : " ", p.unit, phraseDefault(p), p.outside);
  }
  return text;
}

}  // namespace welkin::base
