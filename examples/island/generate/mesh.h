// SPDX-License-Identifier: Apache-2.0
// Shapes of points and faces. Meshes hold them as a glTF file does: with normals, by material.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "generate/geometry.h"

namespace welkin::island {

/// Points with a colour each, and triangles that are counter-clockwise from outside.
struct Shape {
  std::vector<Vec3> points;
  std::vector<Colour> colours;
  std::vector<std::array<int, 3>> faces;

  int point(const Vec3& p, const Colour& colour);
  void quad(int a, int b, int c, int d);
  void append(const Shape& other, const Frame& frame = {});
  /// Turns every face over.
  void flip();
};

/// A point of a grid by row and column.
using GridPoint = std::function<Vec3(int, int)>;
using GridColour = std::function<Colour(int, int)>;

/// Rows of points, joined to a surface. From outside, columns run to the right and rows upward. `closed` joins the last
/// column to the first.
Shape grid(int rows, int columns, bool closed, const GridPoint& point, const GridColour& colour);

/// A box from corner to corner of the frame.
Shape box(const Frame& frame, const Vec3& low, const Vec3& high, const Colour& colour);

/// A closed tube round a line of points, with a radius for each.
Shape tube(const std::vector<Vec3>& centre, const std::vector<double>& radius, int sides, const Colour& colour);

/// A straight tube.
Shape post(const Vec3& from, const Vec3& to, double radius, int sides, const Colour& colour);

/// A subdivided icosahedron whose points, unit vectors, are moved and coloured.
Shape blob(int subdivisions, const std::function<Vec3(const Vec3&)>& place,
           const std::function<Colour(const Vec3&)>& colour);

/// flat: one normal a face; smooth: the area-weighted mean of the faces at each point of the shape.
enum class Shading { flat, smooth };

struct Primitive {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;
  std::vector<std::array<uint8_t, 4>> colours;
  std::vector<uint16_t> indices;
};

class Mesh {
 public:
  /// Appends a shape and leaves out its faces without area. A primitive holds at most 65535 vertices.
  void add(const std::string& material, const Shape& shape, Shading shading);
  const std::map<std::string, Primitive>& primitives() const { return primitives_; }

 private:
  struct Key {
    std::array<float, 6> geometry;
    std::array<uint8_t, 4> colour;
    auto operator<=>(const Key&) const = default;
  };
  uint16_t vertex(const std::string& material, const Vec3& position, const Vec3& normal, const Colour& colour);

  std::map<std::string, Primitive> primitives_;
  std::map<std::string, std::map<Key, uint16_t>> known_;
};

}  // namespace welkin::island
