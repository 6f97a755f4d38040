// SPDX-License-Identifier: Apache-2.0
// The committed level: what the generator writes, sound glTF that another reader reads, and the content it promises.
#include "generate/island.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generate/geometry.h"
#include "generate/layout.h"
#include "generate/terrain.h"
#include "sky/base/atomic_file.h"

namespace welkin::island {
namespace {

constexpr double kUnitLength = 1e-5;         // a normal's three roundings to float
constexpr double kSmallestArea_m2 = 1e-8;    // below it a face has no direction in float
constexpr double kMostDegenerate = 1e-3;     // share of the faces
constexpr double kColourDistance = 0.15;     // between two walls, linear Rec. 709
constexpr std::size_t kLargest = 2U << 20U;  // bytes of the level
constexpr double kRounding_m = 1e-4;         // translations are rounded to 1e-5

const std::filesystem::path kFolder = ISLAND_FOLDER;

const tinygltf::Model& model() {
  static const tinygltf::Model loaded = [] {
    tinygltf::Model m;
    tinygltf::TinyGLTF reader;
    std::string error;
    std::string warning;
    const bool isRead = reader.LoadASCIIFromFile(&m, &error, &warning, (kFolder / "island.gltf").string());
    INFO(error << warning);
    REQUIRE(isRead);
    REQUIRE(warning.empty());
    return m;
  }();
  return loaded;
}

template <typename T>
std::vector<T> elements(int index) {
  const tinygltf::Accessor& accessor = model().accessors.at(static_cast<std::size_t>(index));
  const tinygltf::BufferView& view = model().bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
  std::vector<T> result(accessor.count);
  for (std::size_t i = 0; i < accessor.count; ++i)
    std::memcpy(&result[i], &model().buffers.at(0).data.at(view.byteOffset + accessor.byteOffset + i * stride),
                sizeof(T));
  return result;
}

using Float3 = std::array<float, 3>;

Vec3 vector(const Float3& v) {
  return Vec3(Vector3<float>(v[0], v[1], v[2]));
}

template <typename F>
void forEachPrimitive(F f) {
  int count = 0;
  for (const tinygltf::Mesh& mesh : model().meshes)
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      CAPTURE(mesh.name, primitive.material);
      f(primitive);
      ++count;
    }
  REQUIRE(count > 20);
}

const tinygltf::Node& node(const std::string& name) {
  const auto found =
      std::find_if(model().nodes.begin(), model().nodes.end(), [&](const auto& n) { return n.name == name; });
  INFO(name);
  REQUIRE(found != model().nodes.end());
  return *found;
}

/// The corners of a node's mesh in its own frame.
std::pair<Vec3, Vec3> bounds(const std::string& name) {
  Vec3 low(1e9);
  Vec3 high(-1e9);
  for (const auto& primitive : model().meshes.at(static_cast<std::size_t>(node(name).mesh)).primitives) {
    const auto& accessor = model().accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
    for (int i = 0; i < 3; ++i) {
      low[i] = min(low[i], accessor.minValues.at(static_cast<std::size_t>(i)));
      high[i] = max(high[i], accessor.maxValues.at(static_cast<std::size_t>(i)));
    }
  }
  return {low, high};
}

TEST_CASE("Island, GeneratorWritesTheCommittedBytes") {
  const GltfFiles files = islandFiles();
  const std::vector<std::byte> json = base::readFile(kFolder / "island.gltf");
  const bool isSameJson =
      json.size() == files.json.size() && std::memcmp(json.data(), files.json.data(), json.size()) == 0;
  CHECK(isSameJson);
  const bool isSameBinary = base::readFile(kFolder / "island.bin") == files.binary;
  CHECK(isSameBinary);
  CHECK(files.json.size() + files.binary.size() < kLargest);
}

TEST_CASE("Island, BufferViewsLieInTheFileAndAreAligned") {
  REQUIRE(model().buffers.size() == 1);
  for (const tinygltf::BufferView& view : model().bufferViews) {
    CHECK(view.byteOffset % 4 == 0);
    CHECK(view.byteOffset + view.byteLength <= model().buffers[0].data.size());
  }
  for (const tinygltf::Accessor& accessor : model().accessors) {
    const tinygltf::BufferView& view = model().bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
    CHECK(accessor.count > 0);
    CHECK(accessor.byteOffset % 4 == 0);
    CHECK(accessor.byteOffset + accessor.count * stride <= view.byteLength);
  }
  CHECK(model().extensionsRequired.empty());
  CHECK(model().extensionsUsed.empty());
}

TEST_CASE("Island, PositionsLieBetweenMinAndMax") {
  forEachPrimitive([](const tinygltf::Primitive& primitive) {
    const auto& accessor = model().accessors.at(static_cast<std::size_t>(primitive.attributes.at("POSITION")));
    REQUIRE(accessor.minValues.size() == 3);
    REQUIRE(accessor.maxValues.size() == 3);
    Vec3 low(1e9);
    Vec3 high(-1e9);
    for (const Float3& p : elements<Float3>(primitive.attributes.at("POSITION")))
      for (int i = 0; i < 3; ++i) {
        low[i] = min(low[i], vector(p)[i]);
        high[i] = max(high[i], vector(p)[i]);
      }
    for (int i = 0; i < 3; ++i) {
      CHECK(low[i] == accessor.minValues[static_cast<std::size_t>(i)]);
      CHECK(high[i] == accessor.maxValues[static_cast<std::size_t>(i)]);
    }
  });
}

TEST_CASE("Island, FacesAndNormalsAreSound") {
  std::size_t faces = 0;
  std::size_t degenerate = 0;
  std::size_t turned = 0;
  forEachPrimitive([&](const tinygltf::Primitive& primitive) {
    const auto positions = elements<Float3>(primitive.attributes.at("POSITION"));
    const auto normals = elements<Float3>(primitive.attributes.at("NORMAL"));
    const auto colours = elements<std::array<uint8_t, 4>>(primitive.attributes.at("COLOR_0"));
    const auto indices = elements<uint16_t>(primitive.indices);
    REQUIRE(normals.size() == positions.size());
    REQUIRE(colours.size() == positions.size());
    REQUIRE(indices.size() % 3 == 0);
    double worst = 0.0;
    for (const Float3& n : normals) worst = max(worst, std::abs(length(vector(n)) - 1.0));
    CHECK(worst < kUnitLength);  // false for NaN and infinities too
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      REQUIRE(std::max({indices[i], indices[i + 1], indices[i + 2]}) < positions.size());
      const Vec3 a = vector(positions[indices[i]]);
      const Vec3 area = cross(vector(positions[indices[i + 1]]) - a, vector(positions[indices[i + 2]]) - a) / 2.0;
      REQUIRE(std::isfinite(length(area)));
      ++faces;
      if (length(area) < kSmallestArea_m2) ++degenerate;
      const Vec3 mean = vector(normals[indices[i]]) + vector(normals[indices[i + 1]]) + vector(normals[indices[i + 2]]);
      if (dot(mean, area) <= 0.0) ++turned;
    }
  });
  CAPTURE(faces, degenerate, turned);
  CHECK(static_cast<double>(degenerate) <= kMostDegenerate * static_cast<double>(faces));
  CHECK(turned == 0);
}

TEST_CASE("Island, Spans256Metres") {
  for (const char* name : {"terrain", "sea"}) {
    const auto [low, high] = bounds(name);
    CAPTURE(name);
    for (const int i : {0, 2}) {
      CHECK(low[i] == -kHalfExtent_m);
      CHECK(high[i] == kHalfExtent_m);
    }
  }
  const auto [low, high] = bounds("terrain");
  CHECK(low.y < -8.0);
  CHECK(high.y > 32.0);
  CHECK(high.y < 42.0);
}

TEST_CASE("Island, EdgesLieUnderTheSea") {
  double highest = -1e9;
  for (int i = -128; i <= 128; ++i)
    for (const double edge : {-kHalfExtent_m, kHalfExtent_m})
      highest = max(highest, max(height_m(edge, i), height_m(i, edge)));
  CHECK(highest < -3.0);
}

TEST_CASE("Island, HutsHaveWallsOfDistinctColours") {
  std::vector<Vec3> walls;
  for (std::size_t i = 1; i <= kHuts.size(); ++i) {
    const auto& mesh = model().meshes.at(static_cast<std::size_t>(node("hut_" + std::to_string(i)).mesh));
    const std::string wanted = kHuts[i - 1].wall;
    bool isFound = false;
    for (const auto& primitive : mesh.primitives) {
      const auto& material = model().materials.at(static_cast<std::size_t>(primitive.material));
      // the largest primitive of walls; the blanket inside is white too
      if (material.name != wanted || model().accessors.at(static_cast<std::size_t>(primitive.indices)).count < 500)
        continue;
      const auto& c = material.pbrMetallicRoughness.baseColorFactor;
      walls.push_back({c.at(0), c.at(1), c.at(2)});
      isFound = true;
    }
    CAPTURE(wanted);
    CHECK(isFound);
  }
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(i + 1, j + 1);
      CHECK(length(walls[i] - walls[j]) > kColourDistance);
    }
}

TEST_CASE("Island, NodesHaveNamesAndRoles") {
  std::map<std::string, int> count;
  std::set<std::string> names;
  for (const tinygltf::Node& n : model().nodes) {
    CAPTURE(n.name);
    CHECK(names.insert(n.name).second);
    const std::string kind = n.name.substr(0, n.name.find('_'));
    ++count[kind];
    const std::string role = n.extras.Get("role").Get<std::string>();
    CHECK(role == (kind == "palm" || kind == "bush" ? "vegetation" : kind == "sea" ? "water" : "static"));
    CHECK(n.mesh >= 0);
    double square = n.rotation.empty() ? 1.0 : 0.0;
    for (const double q : n.rotation) square += q * q;
    CHECK(square == Approx(1.0).epsilon(1e-12));
  }
  for (const char* one : {"terrain", "sea", "wreck", "cave", "jetty", "boat"}) CHECK(names.count(one) == 1);
  CHECK(count["hut"] == 8);
  CHECK(count["palm"] >= 60);
  CHECK(count["bush"] > 0);
  CHECK(count["rock"] > 0);
}

TEST_CASE("Island, HutsStandOnLand") {
  for (std::size_t i = 1; i <= kHuts.size(); ++i) {
    const auto& t = node("hut_" + std::to_string(i)).translation;
    CAPTURE(i);
    REQUIRE(t.size() == 3);
    CHECK(t[1] > 0.8);
    CHECK(std::abs(t[1] - height_m(t[0], t[2])) < kRounding_m);
  }
}

/// The faces of a node's mesh in world space; the node is turned only about the vertical.
struct Faces {
  std::vector<std::array<Vec3, 3>> corners;

  Faces(const std::string& name, double azimuth_rad) {
    const auto& t = node(name).translation;
    const Frame frame = frameAt(t.empty() ? Vec3() : Vec3(t[0], t[1], t[2]), azimuth_rad);
    for (const auto& primitive : model().meshes.at(static_cast<std::size_t>(node(name).mesh)).primitives) {
      const auto positions = elements<Float3>(primitive.attributes.at("POSITION"));
      const auto indices = elements<uint16_t>(primitive.indices);
      for (std::size_t i = 0; i < indices.size(); i += 3)
        corners.push_back({frame(vector(positions[indices[i]])), frame(vector(positions[indices[i + 1]])),
                           frame(vector(positions[indices[i + 2]]))});
    }
  }

  /// Distance, in lengths of `way`, to the nearest face; whether it is seen from behind.
  struct Hit {
    double along = 1e9;
    bool isBehind = false;
  };
  Hit nearest(const Vec3& from, const Vec3& way) const {
    Hit hit;
    for (const auto& [a, b, c] : corners) {
      // Moeller and Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", 1997
      const Vec3 u = b - a;
      const Vec3 v = c - a;
      const Vec3 p = cross(way, v);
      const double scale = dot(u, p);
      const Vec3 s = from - a;
      const Vec3 q = cross(s, u);
      const double beta = dot(s, p) / scale;
      const double gamma = dot(way, q) / scale;
      const double along = dot(v, q) / scale;
      if (beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0 && along > 0.0 && along < hit.along)
        hit = {along, scale < 0.0};
    }
    return hit;
  }
};

TEST_CASE("Island, TheCaveIsOpenAtItsMouthOnly") {
  const CaveSite site = caveSite();
  const Frame frame = frameAt(site.mouth, site.azimuth_rad);
  const Faces ground("terrain", 0.0);
  const Faces walls("cave", site.azimuth_rad);
  const Vec3 outside = frame({0.0, 1.7, 7.0});
  const Vec3 mouth = frame({0.3, 2.0, -3.0});
  CHECK(ground.nearest(outside, mouth - outside).along > 1.0);
  CHECK(walls.nearest(outside, mouth - outside).along > 1.0);
  for (const Vec3& eye : {frame({2.4, 1.7, -14.0}), frame({0.8, 1.7, -8.0}), mouth}) {
    CHECK((eye == mouth || ground.nearest(eye, {0, 1, 0}).isBehind));  // the hill is above
    int leaks = 0;
    for (uint32_t i = 0; i < 800; ++i) {
      const Vec3 way = {random(1, i, -1, 1), random(2, i, -1, 1), random(3, i, -1, 1)};
      const Faces::Hit hill = ground.nearest(eye, way);
      if (hill.isBehind && hill.along < walls.nearest(eye, way).along) ++leaks;
    }
    CHECK(leaks == 0);
  }
}

}  // namespace
}  // namespace welkin::island
