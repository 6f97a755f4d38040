// SPDX-License-Identifier: Apache-2.0
// Turns the parts of an OBJ file into a scene.
#include "probes/obj/obj_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "probes/geometry/sector.h"
#include "probes/obj/obj_file.h"
#include "probes/obj/obj_material.h"

namespace welkin::obj {
namespace {

template <std::size_t N>
void append(const std::array<float, N>& from, level::FloatRows& to) {
  to.components = static_cast<int>(N);
  to.values.insert(to.values.end(), from.begin(), from.end());
  ++to.count;
}

/// The multiple of kSector_m below the coordinate nearest to 0 within the file's bounds, on each axis. From there
/// floats are as exact far out as at the world's origin.
f64::Number3 originOf(const ObjFile& file) {
  level::Bounds bounds;
  for (const auto& p : file.position)
    if (std::all_of(p.begin(), p.end(), [](double v) { return std::isfinite(v); })) bounds.add({p[0], p[1], p[2]});
  f64::Number3 origin(0.0);
  for (int axis = 0; axis < 3 && !bounds.empty(); ++axis)
    origin[axis] =
        geometry::kSector_m * std::floor(std::clamp(0.0, bounds.low[axis], bounds.high[axis]) / geometry::kSector_m);
  return origin;
}

/// The vertices of a part, one for each different corner.
class PartVertices {
 public:
  /// Positions count from `origin`.
  PartVertices(const ObjFile& file, const ObjPart& part, const f64::Number3& origin) : file_(file), origin_(origin) {
    const auto all = [&](auto has) { return std::all_of(part.corners.begin(), part.corners.end(), has); };
    has_uv_ = all([](const ObjCorner& c) { return c.uv >= 0; });
    has_normals_ = all([](const ObjCorner& c) { return c.normal >= 0; });
    for (const ObjCorner& corner : part.corners) indices_.push_back(vertexOf(corner));
  }

  bool hasUv() const { return has_uv_; }
  const level::Attributes& attributes() const { return attributes_; }
  const std::vector<uint32_t>& indices() const { return indices_; }

 private:
  uint32_t vertexOf(const ObjCorner& c) {
    const auto key = std::tuple(c.position, has_uv_ ? c.uv : -1, has_normals_ ? c.normal : -1);
    const auto [found, is_new] = places_.emplace(key, static_cast<uint32_t>(attributes_.positions.count));
    if (is_new) {
      const auto i = static_cast<std::size_t>(c.position);
      const auto& p = file_.position[i];
      append(std::array{static_cast<float>(p[0] - origin_.x), static_cast<float>(p[1] - origin_.y),
                        static_cast<float>(p[2] - origin_.z)},
             attributes_.positions);
      if (!file_.colour.empty()) append(file_.colour[i], attributes_.colours);
      if (has_normals_) append(file_.normal[static_cast<std::size_t>(c.normal)], attributes_.normals);
      if (has_uv_) {
        const auto& uv = file_.uv[static_cast<std::size_t>(c.uv)];
        append(std::array{uv[0], 1.0F - uv[1]}, attributes_.uv);  // v counts from the top
      }
    }
    return found->second;
  }

  const ObjFile& file_;
  f64::Number3 origin_;
  bool has_uv_ = false;
  bool has_normals_ = false;
  level::Attributes attributes_;
  std::vector<uint32_t> indices_;
  std::map<std::tuple<int32_t, int32_t, int32_t>, uint32_t> places_;
};

class ObjSource : public level::GeometrySource {
 public:
  ObjSource(const std::filesystem::path& path, level::SceneBuilder& builder) : path_(path), builder_(builder) {
    const ObjFile file = readObj(path);
    builder.scene().files.push_back(path);
    if (!file.unknown_words.empty())
      builder.scene().warnings.push_back(fmt::format("{}: not read: {}", path.string(), file.unknown_words));
    origin_.translation = originOf(file);
    ObjMaterials materials(path, file.libraries, builder);
    for (const ObjPart& part : file.parts) {
      const PartVertices vertices(file, part, origin_.translation);
      level::MeshPiece piece = level::appendPiece(builder.scene(), vertices.attributes(), vertices.indices(),
                                                  path.string() + ": object " + part.object);
      piece.material = materials.at(part.material, vertices.hasUv());
      parts_.push_back({part.object, piece});
    }
    materials.warn();
  }

  void place(const level::GeometryEntry& entry) override {
    std::vector<std::string> names;
    for (const Part& part : parts_) names.push_back(part.object);
    builder_.warnOfIdlePatterns(entry, names);
    std::map<std::string, uint32_t> objects;
    for (const Part& part : parts_) {
      const bool vegetation = level::matchesAny(entry.vegetation_nodes, part.object);
      const geometry::Role role = vegetation ? geometry::Role::vegetation : entry.role;
      if (role == geometry::Role::ignored || level::matchesAny(entry.ignore_nodes, part.object)) continue;
      auto known = objects.find(part.object);
      if (known == objects.end()) {
        const std::string name = part.object.empty() ? path_.filename().string() : part.object;
        known = objects.emplace(part.object, builder_.addObject(name, role)).first;
      }
      builder_.place(part.piece, entry.transform * origin_, known->second, entry.albedo);
    }
  }

 private:
  struct Part {
    std::string object;
    level::MeshPiece piece;
  };
  std::filesystem::path path_;
  level::SceneBuilder& builder_;
  std::vector<Part> parts_;
  geometry::Affine origin_;  ///< of the pieces, in the file's axes
};

}  // namespace

std::unique_ptr<level::GeometrySource> readObjSource(const std::filesystem::path& path, level::SceneBuilder& builder) {
  return std::make_unique<ObjSource>(path, builder);
}

}  // namespace welkin::obj
