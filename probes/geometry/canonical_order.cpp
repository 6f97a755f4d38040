// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/canonical_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "probes/geometry/reach.h"

namespace welkin::geometry {

using f64::Number3;
namespace {

using Halves = std::pair<std::uint64_t, std::uint64_t>;

Halves halvesOf(const base::Hash128& hash) {
  return {hash.high, hash.low};
}

/// For each hash, the index of the first equal one.
std::vector<std::uint32_t> firstOfEqual(const std::vector<base::Hash128>& hash) {
  std::map<Halves, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < hash.size(); ++i) result.push_back(first.emplace(halvesOf(hash[i]), i).first->second);
  return result;
}

struct Corners {
  std::array<std::array<double, 3>, 3> position;
  std::array<std::array<float, 2>, 3> uv{};  ///< 0 if there is no texture
  std::array<std::array<float, 3>, 3> colour{{{1.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 1.0F}}};
  std::uint32_t role = 0;
};

class Ordering {
 public:
  explicit Ordering(Surfaces level) : level_(std::move(level)) {
    std::vector<base::Hash128> texture_hash = textureHashes(level_);
    for (std::size_t i = 0; i < texture_hash.size(); ++i) {
      const Texture& t = level_.texture[i];
      base::Hasher hasher;
      for (const int number : {t.width, t.height, static_cast<int>(t.wrap_u), static_cast<int>(t.wrap_v)})
        hasher.add(number);
      hasher.add(texture_hash[i]);
      texture_hash[i] = hasher.digest();
    }
    texture_ = firstOfEqual(texture_hash);
    for (Material m : level_.material) {
      base::Hasher hasher;
      for (int* texture : {&m.texture, &m.emission_texture})
        if (*texture >= 0) {
          hasher.add(texture_hash[static_cast<std::size_t>(*texture)]);
          *texture = 0;
        }
      addTo(hasher, m);
      material_hash_.push_back(hasher.digest());
    }
    material_ = firstOfEqual(material_hash_);
  }

  OrderedLevel run() {
    const std::vector<std::uint32_t> order = orderOfTriangles();
    std::vector<base::Hash128> content;
    content.reserve(order.size());
    std::vector<Triangle> triangle;
    std::vector<std::array<double, 3>> position;
    std::vector<std::array<float, 3>> colour;
    std::vector<std::array<float, 2>> uv;
    triangle.reserve(order.size());
    position.reserve(3 * order.size());
    for (const std::uint32_t i : order) {
      const Triangle& old = level_.triangle[i];
      const auto first = static_cast<std::uint32_t>(position.size());
      triangle.push_back({{first, first + 1, first + 2}, material_[old.material], old.object});
      const Corners corners = cornersOf(old);
      content.push_back(content_[i]);
      position.insert(position.end(), corners.position.begin(), corners.position.end());
      if (!level_.uv.empty()) uv.insert(uv.end(), corners.uv.begin(), corners.uv.end());
      if (!level_.colour.empty()) colour.insert(colour.end(), corners.colour.begin(), corners.colour.end());
    }
    level_.triangle = std::move(triangle);
    level_.position = std::move(position);
    level_.uv = std::move(uv);
    level_.colour = std::move(colour);
    for (Material& m : level_.material)
      for (int* texture : {&m.texture, &m.emission_texture})
        if (*texture >= 0) *texture = static_cast<int>(texture_[static_cast<std::size_t>(*texture)]);
    std::sort(level_.light.begin(), level_.light.end(),
              [](const StaticLight& a, const StaticLight& b) { return numbersOf(a) < numbersOf(b); });
    return {std::move(level_), std::move(content)};
  }

 private:
  static std::array<double, 13> numbersOf(const StaticLight& l) {
    return {l.position.x,     l.position.y, l.position.z, l.intensity.x, l.intensity.y,
            l.intensity.z,    l.axis.x,     l.axis.y,     l.axis.z,      l.directional ? 1.0 : 0.0,
            l.inverse_range4, l.cone_scale, l.cone_offset};
  }

  bool isVegetation(const Triangle& t) const { return level_.object[t.object].role == Role::vegetation; }

  Corners cornersOf(const Triangle& t) const {
    Corners c;
    c.role = static_cast<std::uint32_t>(level_.object[t.object].role);
    for (std::size_t i = 0; i < 3; ++i) {
      c.position[i] = level_.position[t.vertex[i]];
      if (level_.material[t.material].isTextured() && !level_.uv.empty()) c.uv[i] = level_.uv[t.vertex[i]];
      if (!level_.colour.empty()) c.colour[i] = level_.colour[t.vertex[i]];
    }
    return c;
  }

  /// Positions count from the corner of the triangle's patch, so the order is the same in every sector.
  base::Hash128 contentOf(const Triangle& t) const {
    struct {
      Corners corners;
      base::Hash128 material;
    } content{cornersOf(t), material_hash_[t.material]};
    static_assert(sizeof(content) ==
                      9 * sizeof(double) + 15 * sizeof(float) + sizeof(content.corners.role) + sizeof(content.material),
                  "no padding");
    const auto [i, k] = patchOf(level_, t);
    for (auto& p : content.corners.position) {
      p[0] -= kPatch_m * i;
      p[2] -= kPatch_m * k;
    }
    return base::hashOf(std::as_bytes(std::span(&content, 1)));
  }

  /// For each vegetation object, a hash of its triangles in any order; the same value for all other objects.
  std::vector<base::Hash128> vegetationHashes(const std::vector<base::Hash128>& content) const {
    std::vector<std::vector<Halves>> triangles(level_.object.size());
    for (std::size_t i = 0; i < content.size(); ++i)
      if (isVegetation(level_.triangle[i])) triangles[level_.triangle[i].object].push_back(halvesOf(content[i]));
    std::vector<base::Hash128> result;
    for (auto& t : triangles) {
      std::sort(t.begin(), t.end());
      result.push_back(base::hashOf(std::as_bytes(std::span(t))));
    }
    return result;
  }

  std::vector<std::uint32_t> orderOfTriangles() {
    content_.reserve(level_.triangle.size());
    for (const Triangle& t : level_.triangle) content_.push_back(contentOf(t));
    const std::vector<base::Hash128> vegetation = vegetationHashes(content_);
    const auto keyOf = [&](std::uint32_t i) {
      const std::uint32_t object = level_.triangle[i].object;
      // Patches first put neighbours in the world near each other in memory too.
      return std::tuple(patchOf(level_, level_.triangle[i]), halvesOf(content_[i]), halvesOf(vegetation[object]),
                        object, i);
    };
    std::vector<decltype(keyOf(0))> order;
    order.reserve(content_.size());
    for (std::uint32_t i = 0; i < content_.size(); ++i) order.push_back(keyOf(i));
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> result;
    result.reserve(order.size());
    for (const auto& key : order) {
      const std::uint32_t i = std::get<4>(key);
      const bool again = !result.empty() && content_[i] == content_[result.back()] &&
                         patchOf(level_, level_.triangle[i]) == patchOf(level_, level_.triangle[result.back()]);
      if (!again || isVegetation(level_.triangle[i])) result.push_back(i);
    }
    return result;
  }

  Surfaces level_;
  std::vector<std::uint32_t> texture_, material_;  // for each index, the first one that is equal
  std::vector<base::Hash128> material_hash_;
  std::vector<base::Hash128> content_;
};

}  // namespace

std::pair<int, int> patchOf(const Surfaces& level, const Triangle& triangle) {
  const auto& p = level.position[triangle.vertex[0]];
  return {static_cast<int>(std::floor(p[0] / kPatch_m)), static_cast<int>(std::floor(p[2] / kPatch_m))};
}

OrderedLevel orderedLevel(Surfaces level) {
  return Ordering(std::move(level)).run();
}

Surfaces inCanonicalOrder(Surfaces level) {
  return orderedLevel(std::move(level)).surfaces;
}

}  // namespace welkin::geometry
