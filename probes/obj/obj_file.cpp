// SPDX-License-Identifier: Apache-2.0
#include "probes/obj/obj_file.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "probes/obj/polygon.h"
#include "probes/obj/text_lines.h"
#include "probes/obj/unknown_words.h"
#include "sky/base/atomic_file.h"
#include "sky/base/message.h"

namespace welkin::obj {
namespace {

using f64::Number3;

/// Keywords that change no light: points, lines, smoothing, and how other programs show a model.
const std::set<std::string_view> kObjWithoutLight = {"p",        "l",        "s",  "mg",         "lod",      "bevel",
                                                     "c_interp", "d_interp", "vp", "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& path, std::string_view text) : lines_(path.string(), text) {}

  ObjFile read() {
    while (lines_.next()) readLine(lines_.keyword());
    file_.unknown_words = unknown_.text();
    return std::move(file_);
  }

 private:
  void readLine(std::string_view keyword) {
    if (keyword == "v")
      readVertex();
    else if (keyword == "vt")
      file_.uv.push_back({numberAt(1), lines_.words().size() > 2 ? numberAt(2) : 0.0F});
    else if (keyword == "vn")
      file_.normal.push_back({numberAt(1), numberAt(2), numberAt(3)});
    else if (keyword == "f" || keyword == "fo")  // fo: an older word for f
      readFace();
    else if (keyword == "o" || keyword == "g")
      object_ = lines_.nameFrom(1);
    else if (keyword == "usemtl")
      material_ = lines_.nameFrom(1);
    else if (keyword == "mtllib")
      readLibrary();
    else if (kObjWithoutLight.count(keyword) == 0)
      unknown_.add(keyword, lines_.lineNumber());
  }

  /// Exporters repeat the line before every object.
  void readLibrary() {
    constexpr std::size_t kMostBytes = 65536;
    std::string names(lines_.nameFrom(1));
    if (names.size() > kMostBytes)
      lines_.refuse(fmt::format("mtllib with {} bytes of names; at most {} are allowed", names.size(), kMostBytes));
    if (libraries_.insert(names).second) file_.libraries.push_back(std::move(names));
  }

  float numberAt(std::size_t i) const { return static_cast<float>(lines_.number(i)); }

  /// Reads x y z, then an optional weight or an optional colour.
  void readVertex() {
    constexpr std::size_t kWordsWithColour = 7;
    file_.position.push_back({lines_.number(1), lines_.number(2), lines_.number(3)});
    if (lines_.words().size() < kWordsWithColour) {
      if (!file_.colour.empty()) file_.colour.push_back({1.0F, 1.0F, 1.0F});
      return;
    }
    file_.colour.resize(file_.position.size() - 1, {1.0F, 1.0F, 1.0F});
    file_.colour.push_back({numberAt(4), numberAt(5), numberAt(6)});
    for (const float c : file_.colour.back())
      if (c < 0.0F || c > 1.0F) lines_.refuse(fmt::format("a vertex colour holds {}, must be 0 to 1", c));
  }

  /// Converts an index that counts from 1, or from the end if negative, to an index into a list of `count`.
  int32_t placeOf(std::string_view word, std::size_t count, const char* what) const {
    int i = 0;
    if (!parseWhole(word, i))
      lines_.refuse(fmt::format("\"{}\" is not the number of a {}", base::shortened(word, 40), what));
    const auto n = static_cast<int64_t>(count);
    const int64_t place = i < 0 ? n + i : int64_t{i} - 1;
    if (i == 0 || place < 0 || place >= n)
      lines_.refuse(fmt::format("{} {} is none of the {} before this line", what, i, n));
    return static_cast<int32_t>(place);
  }

  ObjCorner readCorner(std::string_view word) const {
    std::string_view field[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t end = word.find('/');
      field[i] = word.substr(0, end);
      word.remove_prefix(end == std::string_view::npos ? word.size() : end + 1);
    }
    ObjCorner corner;
    corner.position = placeOf(field[0], file_.position.size(), "vertex");
    if (!field[1].empty()) corner.uv = placeOf(field[1], file_.uv.size(), "texture coordinate");
    if (!field[2].empty()) corner.normal = placeOf(field[2], file_.normal.size(), "normal");
    return corner;
  }

  void readFace() {
    constexpr std::size_t kMostCorners = 16384;
    const std::size_t count = lines_.words().size() - 1;
    if (count < 3 || count > kMostCorners)
      lines_.refuse(fmt::format("a face with {} corners; 3 to {} are allowed", count, kMostCorners));
    std::vector<ObjCorner> corners;
    std::vector<Number3> points;
    for (std::size_t i = 1; i <= count; ++i) {
      corners.push_back(readCorner(lines_.words()[i]));
      const auto& p = file_.position[static_cast<std::size_t>(corners.back().position)];
      points.emplace_back(p[0], p[1], p[2]);
    }
    ObjPart& part = partOf();
    for (const auto& triangle : trianglesOf(points))
      for (const std::size_t corner : triangle) part.corners.push_back(corners[corner]);
  }

  ObjPart& partOf() {
    const auto [found, is_new] = parts_.emplace(std::pair(object_, material_), file_.parts.size());
    if (is_new) file_.parts.push_back({object_, material_, {}});
    return file_.parts[found->second];
  }

  TextLines lines_;
  ObjFile file_;
  std::string object_;
  std::string material_;
  std::map<std::pair<std::string, std::string>, std::size_t> parts_;
  std::set<std::string> libraries_;
  UnknownWords unknown_;
};

}  // namespace

ObjFile readObj(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = base::readFile(path);
  return ObjReader(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}).read();
}

}  // namespace welkin::obj
