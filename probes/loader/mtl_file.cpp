// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/mtl_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "probes/loader/text_lines.h"
#include "sky/base/atomic_file.h"

namespace welkin::loader {
namespace {

using f64::Number3;

/// Whether the word looks like a number.
bool isNumber(std::string_view word) {
  return !word.empty() && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
}

double inRange(const TextLines& lines, std::size_t i, double most) {
  const double value = lines.number(i);
  if (!(value >= 0.0 && value <= most))
    lines.refuse(fmt::format("{} holds {}, must be 0 to {}", lines.words()[0], value, most));
  return value;
}

/// Reads a colour; a single number is grey.
Number3 readColour(const TextLines& lines, double most) {
  if (lines.words().size() > 1 && !isNumber(lines.words()[1]))
    lines.refuse(fmt::format("{} must be followed by numbers", lines.words()[0]));
  if (lines.words().size() < 3) return Number3(inRange(lines, 1, most));
  return {inRange(lines, 1, most), inRange(lines, 2, most), inRange(lines, 3, most)};
}

/// Reads options, each with a fixed number of words, then a file name that may contain spaces.
MtlMap readMap(const TextLines& lines) {
  static const std::map<std::string_view, std::size_t> kOneWordOptions = {
      {"-blendu", 1}, {"-blendv", 1}, {"-cc", 1},      {"-clamp", 1}, {"-texres", 1},
      {"-bm", 1},     {"-boost", 1},  {"-imfchan", 1}, {"-type", 1},  {"-mm", 2}};
  const auto& words = lines.words();
  MtlMap map;
  std::size_t i = 1;
  while (i < words.size() && words[i].starts_with('-')) {
    const std::string_view option = words[i++];
    if (option == "-o" || option == "-s" || option == "-t") {
      for (std::size_t axis = 0; axis < 3 && i < words.size() && isNumber(words[i]); ++axis, ++i) {
        const double value = lines.number(i);
        if (!(std::abs(value) <= 1e6)) lines.refuse(fmt::format("{} holds {}", option, value));
        if (axis < 2 && option == "-o") map.offset[axis] = value;
        if (axis < 2 && option == "-s") map.scale[axis] = value;
      }
      continue;
    }
    const auto known = kOneWordOptions.find(option);
    if (known == kOneWordOptions.end()) lines.refuse(fmt::format("{} is not an option of {}", option, words[0]));
    if (option == "-clamp" && i < words.size()) map.clamped = words[i] == "on";
    i += known->second;
  }
  if (i >= words.size()) lines.refuse(fmt::format("{} names no image", words[0]));
  map.file.assign(words[i].data(), words.back().data() + words.back().size());
  std::replace(map.file.begin(), map.file.end(), '\\', '/');
  return map;
}

}  // namespace

std::vector<MtlMaterial> readMtl(const std::filesystem::path& path) {
  constexpr double kBrightest = 1e9;
  const std::vector<std::byte> bytes = base::readFile(path);
  TextLines lines(path.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  std::vector<MtlMaterial> materials;
  while (lines.next()) {
    const std::string_view key = lines.words()[0];
    if (key == "newmtl") {
      if (lines.rest().empty()) lines.refuse("newmtl names no material");
      materials.emplace_back().name = lines.rest();
      continue;
    }
    if (key != "Kd" && key != "Ke" && key != "d" && key != "Tr" && key != "map_Kd" && key != "map_d") continue;
    if (materials.empty()) lines.refuse(fmt::format("{} before the first newmtl", key));
    MtlMaterial& material = materials.back();
    if (key == "Kd") material.diffuse = readColour(lines, 1.0);
    if (key == "Ke") material.emission = readColour(lines, kBrightest);
    if (key == "d") material.dissolve = inRange(lines, lines.words().size() > 2 ? 2 : 1, 1.0);  // d -halo factor
    if (key == "Tr") material.dissolve = 1.0 - inRange(lines, 1, 1.0);
    if (key == "map_Kd") material.diffuse_map = readMap(lines);
    if (key == "map_d") material.alpha_map = readMap(lines).file;
  }
  return materials;
}

}  // namespace welkin::loader
