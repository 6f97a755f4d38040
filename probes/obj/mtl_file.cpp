// SPDX-License-Identifier: Apache-2.0
#include "probes/obj/mtl_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "probes/obj/text_lines.h"
#include "probes/obj/unknown_words.h"
#include "sky/base/atomic_file.h"

namespace welkin::obj {
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
  static const std::map<std::string, std::size_t> kOneWordOptions = {
      {"-blendu", 1}, {"-blendv", 1}, {"-cc", 1},      {"-clamp", 1}, {"-texres", 1},
      {"-bm", 1},     {"-boost", 1},  {"-imfchan", 1}, {"-type", 1},  {"-mm", 2}};
  const auto& words = lines.words();
  MtlMap map;
  std::size_t i = 1;
  while (i < words.size() && words[i].starts_with('-')) {
    const std::string option = lowerCase(words[i++]);
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
    if (option == "-clamp" && i < words.size()) map.clamped = lowerCase(words[i]) == "on";
    i += known->second;
  }
  if (i >= words.size()) lines.refuse(fmt::format("{} names no image", words[0]));
  map.file = lines.nameFrom(i);
  std::replace(map.file.begin(), map.file.end(), '\\', '/');
  return map;
}

/// Keywords that change no diffuse light: highlights, reflections, normals.
const std::set<std::string_view> kMtlWithoutLight = {
    "ka",       "ks",     "ns",     "ni",       "km",       "illum",   "sharpness", "map_ka", "map_ks",
    "map_ns",   "map_ni", "map_km", "refl",     "map_refl", "bump",    "map_bump",  "disp",   "norm",
    "map_disp", "pr",     "pm",     "ps",       "pc",       "pcr",     "aniso",     "anisor", "map_pr",
    "map_pm",   "map_ps", "map_pc", "map_norm", "map_aat",  "map_rma", "map_orm"};

class MtlReader {
 public:
  MtlReader(const std::filesystem::path& path, std::string_view text) : lines_(path.string(), text) {}

  MtlFile read() {
    while (lines_.next()) readLine(lines_.keyword());
    finishMaterial();
    if (const std::string words = unknown_.text(); !words.empty()) warn("not read: " + words);
    return std::move(file_);
  }

 private:
  void readLine(const std::string& key) {
    constexpr double kBrightest = 1e9;
    static const std::set<std::string_view> kRead = {"kd", "ke", "d", "tr", "map_kd", "map_ke", "map_d"};
    if (key == "newmtl") return beginMaterial();
    if (key == "tf" && passesAll()) return;
    if (kRead.count(key) == 0) {
      if (kMtlWithoutLight.count(key) == 0) unknown_.add(key, lines_.lineNumber());
      return;
    }
    if (!has_material_) lines_.refuse(fmt::format("{} before the first newmtl", lines_.words()[0]));
    if (key == "kd") material_.diffuse = readColour(lines_, 1.0);
    if (key == "ke") material_.emission = readColour(lines_, kBrightest);
    if (key == "d") dissolve_ = inRange(lines_, lines_.words().size() > 2 ? 2 : 1, 1.0);  // d -halo factor
    if (key == "tr") transparency_ = inRange(lines_, 1, 1.0);
    if (key == "map_kd") material_.diffuse_map = readMap(lines_);
    if (key == "map_ke") material_.emission_map = readMap(lines_);
    if (key == "map_d") material_.alpha_map = readMap(lines_).file;
  }

  /// Whether Tf is 1 1 1, as exporters write beside opaque surfaces too.
  bool passesAll() const {
    const auto& words = lines_.words();
    return std::all_of(words.begin() + 1, words.end(), [](std::string_view word) {
      return word == "1" || (word.starts_with("1.") && word.find_first_not_of('0', 2) == std::string_view::npos);
    });
  }

  void beginMaterial() {
    finishMaterial();
    const std::string_view name = lines_.nameFrom(1);
    if (name.empty()) lines_.refuse("newmtl names no material");
    has_material_ = true;
    material_.name = name;
  }

  /// Some exporters write Tr with the meaning of d, beside d.
  void finishMaterial() {
    if (!has_material_) return;
    if (dissolve_ && transparency_ && *dissolve_ != 1.0 - *transparency_)
      warn(fmt::format("material {}: d {} and Tr {} differ: d counts", material_.name, *dissolve_, *transparency_));
    material_.dissolve = dissolve_.value_or(1.0 - transparency_.value_or(0.0));
    if (names_.insert(material_.name).second)
      file_.materials.push_back(std::move(material_));
    else if (!has_twins_) {
      has_twins_ = true;
      warn(fmt::format("material {} is there more than once: the first counts", material_.name));
    }
    material_ = {};
    dissolve_.reset();
    transparency_.reset();
  }

  void warn(std::string message) { file_.warnings.push_back(std::move(message)); }

  TextLines lines_;
  MtlFile file_;
  MtlMaterial material_;
  bool has_material_ = false;
  bool has_twins_ = false;
  std::optional<double> dissolve_, transparency_;
  std::set<std::string> names_;
  UnknownWords unknown_;
};

}  // namespace

MtlFile readMtl(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = base::readFile(path);
  return MtlReader(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}).read();
}

}  // namespace welkin::obj
