// SPDX-License-Identifier: Apache-2.0
#include "parameter_text.h"

#include <fmt/format.h>

#include <map>

namespace welkin::tests {

using base::Kind;
using base::Parameter;

std::string numberText(double value) {
  return fmt::format("{}", value);
}

std::string valueText(const Parameter& p, const std::string& number) {
  switch (p.kind) {
    case Kind::colour:
    case Kind::colour_or_keys:
    case Kind::gradient:
    case Kind::tint:
      return fmt::format("[0.5, {}, 0.25]", number);
    case Kind::part:
      break;
    default:
      return number;
  }
  if (p.part == "azimuth_deg") return fmt::format("[[3, {}, 10]]", number);
  if (p.part == "elevation_deg") return fmt::format("[[3, 20, {}]]", number);
  // The other coefficients are chosen so that this one may have as many of its values as possible.
  if (p.part == "a") return fmt::format("[{}, -10000, 0, -1, 0]", number);
  if (p.part == "b") return fmt::format("[0, {}, 0, -1, 0]", number);
  if (p.part == "c") return fmt::format("[0, -1, {}, -1e-9, 0]", number);
  if (p.part == "d") return fmt::format("[0, -1, 0, {}, 0]", number);
  if (p.part == "e") return fmt::format("[0, -1, 0, -1, {}]", number);
  return fmt::format("[[{}, 1]]", number);  // a key's time
}

std::string fileText(const Parameter& p, const std::string& value) {
  const std::string section(p.section.empty() ? "sky" : p.section);
  const std::string key(p.section.empty() ? "intensity" : p.key);
  std::map<std::string, std::map<std::string, std::string>> sections;
  sections["sky"];
  if (section == "sun" && p.without_path)
    sections["sun"] = {{"latitude_deg", "10"}, {"day_of_year", "80"}};
  else
    sections["sun"] = {{"path", "[[0, 0, 45]]"}};
  if (section == "moon" && p.without_path)
    sections["moon"] = {{"declination_deg", "5"}, {"phase", "0.25"}, {"latitude_deg", "10"}};
  else if (section == "moon")
    sections["moon"] = {{"path", "[[0, 0, 45]]"}};
  if (section == "stars") sections["stars"] = {{"image", "\"stars.ppm\""}, {"intensity", "1"}};
  if (key == "cubemap_size")
    sections["bake"].emplace("cubemap_times", "1");  // more of the largest would be too many bytes
  sections[section][key] = value;
  std::string text;
  for (const auto& [name, keys] : sections) {
    text += "[" + name + "]\n";
    for (const auto& [k, v] : keys) text += k + " = " + v + "\n";
  }
  return text;
}

}  // namespace welkin::tests
