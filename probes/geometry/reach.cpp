// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/reach.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include "probes/geometry/canonical_order.h"

namespace welkin::geometry {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Numbers items in the order in which they are asked for.
class Renumbering {
 public:
  explicit Renumbering(std::size_t things) : number_(things, kNone) {}

  /// The new number of an item. `first` is called with the old number when the item gets a new one.
  template <typename First>
  std::uint32_t of(std::uint32_t old, const First& first) {
    if (number_[old] == kNone) {
      number_[old] = next_++;
      first(old);
    }
    return number_[old];
  }

 private:
  std::vector<std::uint32_t> number_;
  std::uint32_t next_ = 0;
};

bool touches(const Surfaces& level, const Triangle& triangle, const Column& column) {
  const auto& a = level.position[triangle.vertex[0]];
  const auto& b = level.position[triangle.vertex[1]];
  const auto& c = level.position[triangle.vertex[2]];
  const auto least = [&](std::size_t axis) { return std::min(a[axis], std::min(b[axis], c[axis])); };
  const auto most = [&](std::size_t axis) { return std::max(a[axis], std::max(b[axis], c[axis])); };
  return column.touches(least(0), most(0), least(2), most(2));
}

/// Builds the part triangle by triangle.
class ReachedPart {
 public:
  explicit ReachedPart(const Surfaces& level)
      : level_(level), material_(level.material.size()), texture_(level.texture.size()), object_(level.object.size()) {}

  void add(const Triangle& triangle) {
    Triangle copy;
    copy.material = material_.of(triangle.material, [&](std::uint32_t m) { addMaterial(m); });
    copy.object = object_.of(oneForAll(triangle.object), [&](std::uint32_t o) {
      near_.surfaces.object.push_back({"", level_.object[o].role});
    });
    const bool textured = near_.surfaces.material[copy.material].isTextured() && !level_.uv.empty();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t old = triangle.vertex[i];
      copy.vertex[i] = static_cast<std::uint32_t>(near_.surfaces.position.size());
      near_.surfaces.position.push_back(level_.position[old]);
      uv_.push_back(textured ? level_.uv[old] : std::array{0.0F, 0.0F});
      colour_.push_back(level_.colour.empty() ? kWhite : level_.colour[old]);
      any_colour_ = any_colour_ || colour_.back() != kWhite;
    }
    any_texture_ = any_texture_ || textured;
    near_.surfaces.triangle.push_back(copy);
  }

  NearSurfaces finish(const Column& column) {
    if (any_texture_) near_.surfaces.uv = std::move(uv_);
    if (any_colour_) near_.surfaces.colour = std::move(colour_);
    for (const StaticLight& light : level_.light)
      if (light.directional || column.holds(light.position)) near_.surfaces.light.push_back(light);
    return std::move(near_);
  }

 private:
  static constexpr std::array<float, 3> kWhite{1.0F, 1.0F, 1.0F};

  /// The object that stands for this one. Only vegetation objects stay separate, because their boxes matter.
  std::uint32_t oneForAll(std::uint32_t object) {
    const Role role = level_.object[object].role;
    return role == Role::vegetation ? object : of_role_.emplace(role, object).first->second;
  }

  void addMaterial(std::uint32_t m) {
    Material material = level_.material[m];
    for (int* texture : {&material.texture, &material.emission_texture})
      if (*texture >= 0)
        *texture = static_cast<int>(texture_.of(static_cast<std::uint32_t>(*texture), [&](std::uint32_t t) {
          const Texture& whole = level_.texture[t];
          near_.surfaces.texture.push_back({whole.width, whole.height, {}, whole.wrap_u, whole.wrap_v});
          near_.texture.push_back(t);
        }));
    near_.surfaces.material.push_back(material);
  }

  const Surfaces& level_;
  Renumbering material_, texture_, object_;
  std::map<Role, std::uint32_t> of_role_;
  NearSurfaces near_;
  std::vector<std::array<float, 2>> uv_;
  std::vector<std::array<float, 3>> colour_;
  bool any_texture_ = false;
  bool any_colour_ = false;
};

/// The same with positions from the sector's corner.
NearSurfaces fromCorner(SectorId sector, NearSurfaces near) {
  const Number3 corner = cornerOf(sector);
  for (auto& p : near.surfaces.position) {
    p[0] -= corner.x;
    p[2] -= corner.z;
  }
  for (StaticLight& light : near.surfaces.light) light.position = light.position - corner;
  return near;
}

void addTo(base::Hasher& hasher, const Number3& v) {
  for (const double number : {v.x, v.y, v.z}) hasher.add(number);
}

}  // namespace

Column columnOf(SectorId sector, double reach_m) {
  return {sector.x * kSector_m - reach_m, (sector.x + 1) * kSector_m + reach_m, sector.z * kSector_m - reach_m,
          (sector.z + 1) * kSector_m + reach_m};
}

NearSurfaces surfacesWithin(const Surfaces& level, const Column& column) {
  ReachedPart part(level);
  for (const Triangle& triangle : level.triangle)
    if (touches(level, triangle, column)) part.add(triangle);
  return part.finish(column);
}

NearSurfaces surfacesAbout(const Surfaces& level, SectorId sector, const Column& column) {
  return fromCorner(sector, surfacesWithin(level, column));
}

base::Hash128 hashAbout(const Surfaces& level, const std::vector<base::Hash128>& content, SectorId sector,
                        const Column& column) {
  constexpr int kPatches = static_cast<int>(kSector_m / kPatch_m);
  struct Found {
    base::Hash128 content;
    std::int32_t patch_x, patch_z;
    std::uint64_t tree;  ///< number of a vegetation object in the order of first use; 0 for others
  };
  Renumbering trees(level.object.size());
  std::vector<Found> found;
  for (std::size_t i = 0; i < level.triangle.size(); ++i) {
    const Triangle& t = level.triangle[i];
    if (!touches(level, t, column)) continue;
    const auto [x, z] = patchOf(level, t);
    const bool tree = level.object[t.object].role == Role::vegetation;
    found.push_back({content[i], x - kPatches * sector.x, z - kPatches * sector.z,
                     tree ? 1 + std::uint64_t{trees.of(t.object, [](std::uint32_t) {})} : 0});
  }
  base::Hasher hasher;
  hasher.addAll(std::span<const Found>(found));
  addTo(hasher, fromCorner(sector, ReachedPart(level).finish(column)), {});  // the lights
  return hasher.digest();
}

Surfaces withTexels(NearSurfaces near, const Surfaces& level) {
  for (std::size_t i = 0; i < near.texture.size(); ++i)
    near.surfaces.texture[i].rgba = level.texture[near.texture[i]].rgba;
  return std::move(near.surfaces);
}

std::vector<base::Hash128> textureHashes(const Surfaces& level) {
  std::vector<base::Hash128> hashes;
  for (const Texture& t : level.texture) hashes.push_back(base::hashOf(std::as_bytes(std::span(t.rgba))));
  return hashes;
}

void addTo(base::Hasher& hasher, const Material& m) {
  addTo(hasher, m.albedo);
  addTo(hasher, m.emission);
  hasher.add(m.texture);
  hasher.add(m.emission_texture);
  for (const UvRows& rows : {m.uv_row, m.emission_uv_row})
    for (const auto& row : rows)
      for (const double number : row) hasher.add(number);
  hasher.add(m.alpha);
  hasher.add(m.alpha_cutoff);
  hasher.add(std::uint8_t{m.blended});
  hasher.add(m.transmission);
  hasher.add(std::uint8_t{m.double_sided});
}

void addTo(base::Hasher& hasher, const NearSurfaces& near, const std::vector<base::Hash128>& texture_hash) {
  const Surfaces& s = near.surfaces;
  hasher.addAll(std::span(s.position));
  hasher.addAll(std::span(s.uv));
  hasher.addAll(std::span(s.colour));
  hasher.addAll(std::span(s.triangle));
  hasher.add(std::uint64_t{s.material.size()});
  for (const Material& material : s.material) addTo(hasher, material);
  hasher.add(std::uint64_t{s.texture.size()});
  for (std::size_t i = 0; i < s.texture.size(); ++i) {
    const Texture& t = s.texture[i];
    hasher.add(t.width);
    hasher.add(t.height);
    hasher.add(t.wrap_u);
    hasher.add(t.wrap_v);
    hasher.add(texture_hash[near.texture[i]]);
  }
  hasher.add(std::uint64_t{s.object.size()});
  for (const Object& object : s.object) hasher.add(object.role);
  hasher.add(std::uint64_t{s.light.size()});
  for (const StaticLight& light : s.light) {
    for (const Number3& v : {light.position, light.intensity, light.axis}) addTo(hasher, v);
    hasher.add(std::uint8_t{light.directional});
    for (const double number : {light.inverse_range4, light.cone_scale, light.cone_offset}) hasher.add(number);
  }
}

}  // namespace welkin::geometry
