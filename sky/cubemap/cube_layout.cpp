// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cube_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "sky/cubemap/cubemap.h"

namespace welkin::cubemap {

using det::Number3;
namespace {

CubeLayout strip(const std::string& name, bool across, Layout orientation) {
  CubeLayout layout;
  layout.name = name;
  layout.across = across ? 6 : 1;
  layout.down = across ? 1 : 6;
  if (orientation == Layout::exr_cube) layout.rule = sh::TexelRule::edge_centres;
  for (int f = 0; f < 6; ++f) {
    const FaceAxes axes = faceAxes(orientation, f);
    layout.face[static_cast<std::size_t>(f)] = {across ? f : 0, across ? 0 : f, axes.right, axes.down, axes.normal};
  }
  return layout;
}

/// Index among +x -x +y -y +z -z of an axis with its sign.
std::size_t faceTowards(const Number3& axis) {
  for (int i = 0; i < 3; ++i)
    if (axis[i] != 0.0) return static_cast<std::size_t>(2 * i + (axis[i] < 0.0 ? 1 : 0));
  return 0;
}

// The face beyond an edge, folded back by a quarter turn.
PlacedFace rightOf(const PlacedFace& f) {
  return {f.column + 1, f.line, f.normal * -1.0, f.down, f.right};
}
PlacedFace leftOf(const PlacedFace& f) {
  return {f.column - 1, f.line, f.normal, f.down, f.right * -1.0};
}
PlacedFace above(const PlacedFace& f) {
  return {f.column, f.line - 1, f.right, f.normal, f.down * -1.0};
}
PlacedFace below(const PlacedFace& f) {
  return {f.column, f.line + 1, f.right, f.normal * -1.0, f.down};
}

CubeLayout cross(const std::string& name, bool across, const Number3& middle, const Number3& right, bool upright) {
  CubeLayout layout;
  layout.name = name;
  layout.across = across ? 4 : 3;
  layout.down = across ? 3 : 4;
  const PlacedFace centre{1, 1, right, Number3(0.0, -1.0, 0.0), middle};
  PlacedFace back = across ? rightOf(rightOf(centre)) : below(below(centre));
  if (upright) {
    back.right = back.right * -1.0;
    back.down = back.down * -1.0;
  }
  for (const PlacedFace& face : {centre, rightOf(centre), leftOf(centre), above(centre), below(centre), back})
    layout.face[faceTowards(face.normal)] = face;
  return layout;
}

/// Reads +x, -x, +z or -z off the front of a text.
std::optional<Number3> takeAxis(std::string_view& text) {
  if (text.size() < 2 || (text[0] != '+' && text[0] != '-') || (text[1] != 'x' && text[1] != 'z')) return std::nullopt;
  const double sign = text[0] == '+' ? 1.0 : -1.0;
  const Number3 axis = text[1] == 'x' ? Number3(sign, 0.0, 0.0) : Number3(0.0, 0.0, sign);
  text.remove_prefix(2);
  return axis;
}

std::optional<CubeLayout> crossOf(const std::string& name) {
  std::string_view rest = name;
  const bool across = rest.starts_with("hcross");
  if (!across && !rest.starts_with("vcross")) return std::nullopt;
  rest.remove_prefix(6);
  const bool upright = !across && rest.ends_with(":upright");
  if (upright) rest.remove_suffix(8);
  std::optional<Number3> middle = Number3(0.0, 0.0, 1.0), right = Number3(1.0, 0.0, 0.0);
  if (rest.starts_with(':')) {
    rest.remove_prefix(1);
    middle = takeAxis(rest);
    right = takeAxis(rest);
  }
  if (!rest.empty() || !middle || !right || dot(*middle, *right) != 0.0) return std::nullopt;
  return cross(name, across, *middle, *right, upright);
}

/// The texel that a direction meets.
const float* texelAt(const std::array<sh::CubeFace, 6>& faces, int size, const Number3& direction) {
  const auto& face = *std::max_element(faces.begin(), faces.end(), [&](const sh::CubeFace& a, const sh::CubeFace& b) {
    return dot(a.normal, direction) < dot(b.normal, direction);
  });
  const double depth = dot(face.normal, direction);
  const auto index = [&](const Number3& axis) {
    const double place = (dot(axis, direction) / depth + 1.0) * 0.5 * size;
    return std::clamp(static_cast<int>(std::floor(place)), 0, size - 1);
  };
  return face.rgb + index(face.down) * face.row + std::ptrdiff_t{3} * index(face.right);
}

}  // namespace

std::optional<CubeLayout> cubeLayout(const std::string& name) {
  if (name == "vstrip" || name == "hstrip") return strip(name, name == "hstrip", Layout::vulkan_cube);
  if (name == "exr-cube") return strip(name, false, Layout::exr_cube);
  return crossOf(name);
}

std::vector<CubeLayout> layoutsOfShape(int width, int height) {
  const auto shape = [&](std::int64_t across, std::int64_t down) { return width * down == height * across; };
  std::vector<const char*> names;
  if (shape(1, 6)) names = {"vstrip", "exr-cube"};
  if (shape(6, 1)) names = {"hstrip"};
  if (shape(4, 3)) names = {"hcross:+z+x"};
  if (shape(3, 4)) names = {"vcross:+z+x", "vcross:+z+x:upright"};
  std::vector<CubeLayout> layouts;
  for (const char* name : names) layouts.push_back(*cubeLayout(name));
  return layouts;
}

bool fits(const CubeLayout& layout, const image::Image& image) {
  const int size = image.width / layout.across;
  return size >= (layout.rule == sh::TexelRule::edge_centres ? 2 : 1) && image.width == size * layout.across &&
         image.height == size * layout.down;
}

std::array<sh::CubeFace, 6> facesOf(const CubeLayout& layout, const image::Image& image) {
  std::array<sh::CubeFace, 6> faces;
  const int size = image.width / layout.across;
  const std::ptrdiff_t row = std::ptrdiff_t{3} * image.width;
  for (std::size_t f = 0; f < 6; ++f) {
    const PlacedFace& face = layout.face[f];
    faces[f] = {image.rgb.data() + face.line * size * row + std::ptrdiff_t{3} * face.column * size, row, face.right,
                face.down, face.normal};
  }
  return faces;
}

double seamOf(const CubeLayout& layout, const image::Image& image) {
  const int size = image.width / layout.across;
  const auto faces = facesOf(layout, image);
  double sum = 0.0;
  for (const sh::CubeFace& face : faces)
    for (int i = 0; i < size; ++i) {
      const double along = (2.0 * i + 1.0) / size - 1.0;
      const double inside = 1.0 - 1.0 / size, outside = 1.0 + 1.0 / size;
      for (const auto& side : {std::pair(1.0, 0.0), {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        const auto towards = [&](double edge) {
          const auto [s, t] = side;
          return face.normal + face.right * (s != 0.0 ? s * edge : along) + face.down * (t != 0.0 ? t * edge : along);
        };
        const float* const here = texelAt(faces, size, towards(inside));
        const float* const there = texelAt(faces, size, towards(outside));
        for (int c = 0; c < 3; ++c) {
          const double difference = double{here[c]} - double{there[c]};
          sum += difference * difference;
        }
      }
    }
  return sum / (72.0 * size);
}

}  // namespace welkin::cubemap
