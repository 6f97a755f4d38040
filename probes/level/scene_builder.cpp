// SPDX-License-Identifier: Apache-2.0
#include "probes/level/scene_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace welkin::level {

using f64::Number3;

bool matchesPattern(const std::string& pattern, const std::string& name) {
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string::npos;
  std::size_t after_star = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      after_star = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string::npos) {
      p = star + 1;
      n = ++after_star;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

bool matchesAny(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const auto& p) { return matchesPattern(p, name); });
}

uint32_t SceneBuilder::addMaterial(SceneMaterial material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<uint32_t>(scene_.materials.size() - 1);
}

int SceneBuilder::addTexture(TextureSource source) {
  const auto key = std::pair(source.name, std::pair(source.wrap_u, source.wrap_v));
  const auto [found, is_new] = textures_.emplace(key, static_cast<int>(scene_.textures.size()));
  if (is_new) scene_.textures.push_back(std::move(source));
  return found->second;
}

uint32_t SceneBuilder::addObject(std::string name, geometry::Role role) {
  scene_.objects.push_back({std::move(name), role});
  return static_cast<uint32_t>(scene_.objects.size() - 1);
}

uint32_t SceneBuilder::bareMaterial(const Number3& albedo) {
  const std::vector<double> key{albedo.x, albedo.y, albedo.z};
  if (const auto found = bare_.find(key); found != bare_.end()) return found->second;
  SceneMaterial material;
  material.surface.albedo = albedo;
  return bare_[key] = addMaterial(std::move(material));
}

void SceneBuilder::place(const MeshPiece& piece, const geometry::Affine& t, uint32_t object, const Number3& albedo) {
  if (t.determinant() == 0.0) {
    if (without_volume_.empty() || without_volume_.back() != object) without_volume_.push_back(object);
    return;
  }
  const uint32_t material = piece.material ? *piece.material : bareMaterial(piece.coloured ? Number3(1.0) : albedo);
  const geometry::Role role = scene_.objects[object].role;
  placed_.push_back({&piece, material, role, t.determinant() < 0.0, {t, object}});
  scene_.least_roughness = std::min(scene_.least_roughness, scene_.materials[material].roughness);
  if (piece.bounds.empty()) return;
  Bounds& bounds = role == geometry::Role::water ? scene_.water : scene_.bounds;
  for (int corner = 0; corner < 8; ++corner)
    bounds.add(t.point({(corner & 1) != 0 ? piece.bounds.high.x : piece.bounds.low.x,
                        (corner & 2) != 0 ? piece.bounds.high.y : piece.bounds.low.y,
                        (corner & 4) != 0 ? piece.bounds.high.z : piece.bounds.low.z}));
}

void SceneBuilder::warnOfIdlePatterns(const GeometryEntry& entry, const std::vector<std::string>& names) {
  const std::pair<const char*, const std::vector<std::string>*> lists[] = {
      {"vegetation_nodes", &entry.vegetation_nodes}, {"ignore_nodes", &entry.ignore_nodes}};
  for (const auto& [key, patterns] : lists)
    for (const std::string& pattern : *patterns)
      if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return matchesPattern(pattern, name); }))
        scene_.warnings.push_back(
            fmt::format("{}: {}: \"{}\" fits no node or object", entry.path.string(), key, pattern));
}

Scene SceneBuilder::finish() {
  if (!without_volume_.empty()) {
    const std::size_t more = without_volume_.size() - 1;
    scene_.warnings.push_back(fmt::format("object \"{}\"{} left out: a transform without volume, as a scale of 0 is",
                                          scene_.objects[without_volume_[0]].name,
                                          more > 0 ? fmt::format(" and {} more are", more) : " is"));
  }
  const auto key = [](const Placed& p) {
    return std::tuple(p.role, p.piece->first_index, p.piece->index_count, p.piece->dropped_triangles, p.mirrored,
                      p.material);
  };
  std::stable_sort(placed_.begin(), placed_.end(), [&](const Placed& a, const Placed& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const Placed& p = placed_[i];
    const geometry::Material& surface = scene_.materials[p.material].surface;
    if (i == 0 || key(p) != key(placed_[i - 1])) {
      Draw draw;
      draw.first_index = p.piece->first_index;
      draw.index_count = p.piece->index_count;
      draw.vertex_offset = p.piece->vertex_offset;
      draw.first_instance = static_cast<uint32_t>(scene_.instances.size());
      draw.role = p.role;
      draw.double_sided = surface.double_sided;
      draw.mirrored = p.mirrored;
      draw.material = p.material;
      draw.dropped_triangles = p.piece->dropped_triangles;
      scene_.draws.push_back(draw);
    }
    ++scene_.draws.back().instance_count;
    const geometry::Affine& t = p.placing.transform;
    Instance instance{};
    for (int row = 0; row < 3; ++row) {
      const double numbers[4] = {t.x[row], t.y[row], t.z[row], t.translation[row]};
      for (int c = 0; c < 4; ++c) instance.row[row][c] = static_cast<float>(numbers[c]);
      instance.albedo[row] = static_cast<float>(surface.albedo[row]);
    }
    scene_.instances.push_back(instance);
    scene_.placings.push_back(p.placing);
  }
  return std::move(scene_);
}

}  // namespace welkin::level
