// SPDX-License-Identifier: Apache-2.0
#include "generate/mesh.h"

#include <cmath>
#include <utility>

#include "sky/base/error.h"

namespace welkin::island {
namespace {

constexpr double kSmallestArea = 1e-7;  // m2; smaller faces are left out

std::array<float, 3> single(const Vec3& v) {
  // -0 becomes 0, so that equal vertices have equal bits
  return {static_cast<float>(v.x) + 0.0F, static_cast<float>(v.y) + 0.0F, static_cast<float>(v.z) + 0.0F};
}

uint8_t unsignedByte(double x) {
  return static_cast<uint8_t>(std::floor(clamp(x, 0.0, 1.0) * 255.0 + 0.5));
}

}  // namespace

int Shape::point(const Vec3& p, const Colour& colour) {
  points.push_back(p);
  colours.push_back(colour);
  return static_cast<int>(points.size()) - 1;
}

void Shape::quad(int a, int b, int c, int d) {
  faces.push_back({a, b, c});
  faces.push_back({a, c, d});
}

void Shape::append(const Shape& other, const Frame& frame) {
  const int first = static_cast<int>(points.size());
  for (const Vec3& p : other.points) points.push_back(frame(p));
  colours.insert(colours.end(), other.colours.begin(), other.colours.end());
  for (const auto& f : other.faces) faces.push_back({first + f[0], first + f[1], first + f[2]});
}

void Shape::flip() {
  for (auto& f : faces) std::swap(f[1], f[2]);
}

Shape grid(int rows, int columns, bool closed, const GridPoint& point, const GridColour& colour) {
  Shape shape;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) shape.point(point(row, column), colour(row, column));
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + (closed ? 0 : 1) < columns; ++column) {
      const int next = (column + 1) % columns;
      shape.quad(row * columns + column, row * columns + next, (row + 1) * columns + next,
                 (row + 1) * columns + column);
    }
  return shape;
}

Shape box(const Frame& frame, const Vec3& low, const Vec3& high, const Colour& colour) {
  Shape shape;
  for (int corner = 0; corner < 8; ++corner)
    shape.point(frame({(corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                       (corner & 4) != 0 ? high.z : low.z}),
                colour);
  shape.quad(4, 5, 7, 6);
  shape.quad(1, 0, 2, 3);
  shape.quad(5, 1, 3, 7);
  shape.quad(0, 4, 6, 2);
  shape.quad(6, 7, 3, 2);
  shape.quad(0, 1, 5, 4);
  return shape;
}

Shape tube(const std::vector<Vec3>& centre, const std::vector<double>& radius, int sides, const Colour& colour) {
  const int rows = static_cast<int>(centre.size());
  const auto at = [&](int i) { return centre[static_cast<std::size_t>(i)]; };
  const auto point = [&](int row, int column) {
    const Vec3 axis = at(row + 1 < rows ? row + 1 : row) - at(row > 0 ? row - 1 : row);
    const Frame frame = frameAlong(at(row), axis);
    const double turn = kTau * column / sides;
    const double r = radius[static_cast<std::size_t>(row)];
    return frame({r * det::cos(turn), r * det::sin(turn), 0.0});
  };
  Shape shape = grid(rows, sides, true, point, [&](int, int) { return colour; });
  const int bottom = shape.point(at(0), colour);
  const int top = shape.point(at(rows - 1), colour);
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    shape.faces.push_back({bottom, next, i});
    shape.faces.push_back({top, (rows - 1) * sides + i, (rows - 1) * sides + next});
  }
  return shape;
}

Shape post(const Vec3& from, const Vec3& to, double radius, int sides, const Colour& colour) {
  return tube({from, to}, {radius, radius}, sides, colour);
}

Shape blob(int subdivisions, const std::function<Vec3(const Vec3&)>& place,
           const std::function<Colour(const Vec3&)>& colour) {
  const double g = (1.0 + det::sqrt(5.0)) / 2.0;
  std::vector<Vec3> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::array<int, 3>> faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int i = 0; i < subdivisions; ++i) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, isNew] = middles.try_emplace({a < b ? a : b, a < b ? b : a}, static_cast<int>(points.size()));
      if (isNew) points.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]) / 2.0);
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      for (const auto& face : {std::array{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}}) finer.push_back(face);
    }
    faces = std::move(finer);
    for (Vec3& p : points) p = normalise(p);
  }
  Shape shape;
  for (const Vec3& p : points) shape.point(place(normalise(p)), colour(normalise(p)));
  shape.faces = std::move(faces);
  return shape;
}

uint16_t Mesh::vertex(const std::string& material, const Vec3& position, const Vec3& normal, const Colour& colour) {
  const auto p = single(position);
  const auto n = single(normal);
  const Key key{{p[0], p[1], p[2], n[0], n[1], n[2]},
                {unsignedByte(colour.x), unsignedByte(colour.y), unsignedByte(colour.z), 255}};
  Primitive& primitive = primitives_[material];
  if (primitive.positions.size() >= 65535)
    throw base::Error(base::ExitStatus::internal, material + ": more than 65535 vertices in one primitive");
  const auto [entry, isNew] = known_[material].try_emplace(key, static_cast<uint16_t>(primitive.positions.size()));
  if (isNew) {
    primitive.positions.push_back(p);
    primitive.normals.push_back(n);
    primitive.colours.push_back(key.colour);
  }
  return entry->second;
}

void Mesh::add(const std::string& material, const Shape& shape, Shading shading) {
  const auto at = [&](int i) { return shape.points[static_cast<std::size_t>(i)]; };
  std::vector<Vec3> smooth(shape.points.size());
  std::vector<std::array<int, 3>> faces;
  for (const auto& face : shape.faces) {
    const Vec3 area = cross(at(face[1]) - at(face[0]), at(face[2]) - at(face[0]));
    if (length(area) < 2.0 * kSmallestArea) continue;
    faces.push_back(face);
    for (const int i : face) smooth[static_cast<std::size_t>(i)] += area;
  }
  for (const auto& face : faces) {
    const Vec3 area = normalise(cross(at(face[1]) - at(face[0]), at(face[2]) - at(face[0])));
    for (const int i : face) {
      const auto index = static_cast<std::size_t>(i);
      const bool rounded = shading == Shading::smooth && length(smooth[index]) > kSmallestArea;
      primitives_[material].indices.push_back(
          vertex(material, at(i), rounded ? normalise(smooth[index]) : area, shape.colours[index]));
    }
  }
}

}  // namespace welkin::island
