// SPDX-License-Identifier: Apache-2.0
// The part of a level that a sector's bake reads is the same whatever lies beyond its reach.
#include "probes/geometry/reach.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "probes/geometry/canonical_order.h"
#include "probes/geometry/random.h"
#include "rooms.h"

namespace welkin::tests {
namespace {

base::Hash128 hashOfSector(const geometry::Surfaces& level, geometry::SectorId sector, double reach_m) {
  const geometry::OrderedLevel ordered = geometry::orderedLevel(level);
  return geometry::hashAbout(ordered.surfaces, ordered.content, sector, geometry::columnOf(sector, reach_m));
}

/// A textured floor in sector 0_0.
geometry::Surfaces floorLevel() {
  geometry::Surfaces s;
  s.texture.push_back({1, 1, {10, 20, 30, 255}, geometry::Texture::Wrap::repeat, geometry::Texture::Wrap::clamped});
  const auto material = addMaterial(s, Number3(0.5));
  s.material[material].texture = 0;
  addQuad(s, {1, 0, 1}, {0, 0, 60}, {60, 0, 0}, material);
  s.uv.assign(s.position.size(), {0.25F, 0.75F});
  return s;
}

/// Objects in pairs, and equal triangles of different materials and different trees.
geometry::Surfaces gardenLevel() {
  geometry::Surfaces s = floorLevel();
  s.texture.push_back({1, 1, {200, 20, 30, 255}, geometry::Texture::Wrap::repeat, geometry::Texture::Wrap::repeat});
  const auto plain = addMaterial(s, Number3(0.2));
  const auto painted = addMaterial(s, Number3(0.5));
  s.material[painted].texture = 1;
  for (const std::uint32_t material : {plain, painted, plain}) {
    addQuad(s, {5, 2, 5}, {0, 0, 4}, {4, 0, 0}, material);
    addQuad(s, {300, 2, 5}, {0, 0, 4}, {4, 0, 0}, material);
  }
  for (int tree = 0; tree < 4; ++tree) {
    s.object.push_back({"tree " + std::to_string(tree), geometry::Role::vegetation});
    const std::size_t first = s.triangle.size();
    addQuad(s, {20, 0, 20}, {4, 0, 0}, {0, 5, 0}, plain);  // all trees
    addQuad(s, {20.0 + tree / 2, 0, 20}, {0, 0, 2}, {0, 5, 0}, plain);
    for (std::size_t i = first; i < s.triangle.size(); ++i)
      s.triangle[i].object = static_cast<std::uint32_t>(s.object.size() - 1);
  }
  s.uv.resize(s.position.size(), {0.125F, 0.5F});
  s.light = {{{9, 1, 1}, Number3(1.0)}, {{5, 1, 1}, Number3(2.0)}, {{5, 1, 1}, Number3(1.0)}};
  for (const auto change : {+[](geometry::StaticLight& l) {
                              l.axis = {1, 0, 0};
                            },
                            +[](geometry::StaticLight& l) { l.directional = true; },
                            +[](geometry::StaticLight& l) { l.inverse_range4 = 0.5; },
                            +[](geometry::StaticLight& l) { geometry::setCone(l, 0.1, 0.2); },
                            +[](geometry::StaticLight& l) { geometry::setCone(l, 0.1, 0.3); }}) {
    s.light.push_back({{5, 1, 1}, Number3(1.0)});
    change(s.light.back());
  }
  return s;
}

/// The numbers 0 to count - 1 in random order.
std::vector<std::uint32_t> shuffled(std::size_t count, geometry::Random& random) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.unit() * static_cast<double>(i))]);
  return order;
}

/// The same level as files in another order give it. Some of its materials and textures occur twice.
geometry::Surfaces inAnotherOrder(const geometry::Surfaces& level, std::uint64_t seed) {
  geometry::Random random(seed);
  geometry::Surfaces s;
  const auto texture = shuffled(2 * level.texture.size(), random);
  const auto material = shuffled(2 * level.material.size(), random);
  const auto object = shuffled(level.object.size(), random);
  s.texture.resize(texture.size());
  for (std::size_t i = 0; i < texture.size(); ++i) s.texture[texture[i]] = level.texture[i / 2];
  s.material.resize(material.size());
  for (std::size_t i = 0; i < material.size(); ++i) {
    geometry::Material m = level.material[i / 2];
    if (m.texture >= 0) m.texture = static_cast<int>(texture[2 * static_cast<std::size_t>(m.texture) + i % 2]);
    s.material[material[i]] = m;
  }
  s.object.resize(object.size());
  for (std::size_t i = 0; i < object.size(); ++i) s.object[object[i]] = level.object[i];
  for (const std::uint32_t i : shuffled(level.triangle.size(), random)) {
    const geometry::Triangle& old = level.triangle[i];
    geometry::Triangle t{{}, material[2 * old.material + (random.unit() < 0.5 ? 0 : 1)], object[old.object]};
    for (std::size_t c = 0; c < 3; ++c) {
      t.vertex[c] = static_cast<std::uint32_t>(s.position.size());
      s.position.push_back(level.position[old.vertex[c]]);
      s.uv.push_back(level.material[old.material].texture >= 0 ? level.uv[old.vertex[c]] : std::array{0.75F, 0.75F});
    }
    s.triangle.push_back(t);
  }
  for (const std::uint32_t i : shuffled(level.light.size(), random)) s.light.push_back(level.light[i]);
  return s;
}

}  // namespace

TEST_CASE("Reach, EndsAtItsDistance") {
  const auto trianglesAt = [](double x, double reach_m) {
    geometry::Surfaces s;
    addQuad(s, {x, 0, 10}, {0, 0, 1}, {1, 0, 0}, addMaterial(s, Number3(0.5)));
    return geometry::surfacesWithin(s, geometry::columnOf({1, 0}, reach_m)).surfaces.triangle.size();  // x 64 to 128
  };
  CHECK(trianglesAt(127.5, 0.0) == 2);
  CHECK(trianglesAt(128.5, 0.0) == 0);
  CHECK(trianglesAt(191.5, 64.0) == 2);
  CHECK(trianglesAt(192.5, 64.0) == 0);
  CHECK(trianglesAt(-0.5, 64.0) == 2);
  CHECK(trianglesAt(-1.5, 64.0) == 0);
}

TEST_CASE("Reach, WhatLiesBeyondChangesNothing") {
  const geometry::Surfaces level = floorLevel();
  const base::Hash128 hash = hashOfSector(level, {0, 0}, 16.0);
  geometry::Surfaces more;  // other items first, so that every index differs
  more.texture.push_back({1, 1, {1, 2, 3, 255}, geometry::Texture::Wrap::repeat, geometry::Texture::Wrap::repeat});
  more.object.push_back({"far away", geometry::Role::vegetation});
  addQuad(more, {500, 0, 1}, {0, 0, 60}, {60, 0, 0}, addMaterial(more, Number3(0.1)));
  const auto vertices = static_cast<std::uint32_t>(more.position.size());
  more.uv.assign(vertices, {0.5F, 0.5F});
  more.colour.assign(vertices, {0.1F, 0.2F, 0.3F});
  for (geometry::Material m : level.material) {
    m.texture += 1;
    more.material.push_back(m);
  }
  more.texture.push_back(level.texture[0]);
  more.object.push_back(level.object[0]);
  for (std::size_t i = 0; i < level.position.size(); ++i) {
    more.position.push_back(level.position[i]);
    more.uv.push_back(level.uv[i]);
    more.colour.push_back({1.0F, 1.0F, 1.0F});
  }
  for (geometry::Triangle t : level.triangle) {
    for (auto& v : t.vertex) v += vertices;
    t.material += 1;
    t.object += 1;
    more.triangle.push_back(t);
  }
  more.light.push_back({{500, 1, 1}, Number3(1.0)});
  CHECK(hashOfSector(more, {0, 0}, 16.0) == hash);
  CHECK_FALSE(hashOfSector(more, {0, 0}, 1000.0) == hash);
  const geometry::Surfaces near =
      geometry::withTexels(geometry::surfacesWithin(more, geometry::columnOf({0, 0}, 16.0)), more);
  CHECK(near.texture.size() == 1);
  CHECK(near.texture[0].rgba == level.texture[0].rgba);
  REQUIRE(near.uv.size() == 6);
  for (const auto& uv : near.uv) CHECK(uv == level.uv[0]);
  CHECK(near.colour.empty());
}

TEST_CASE("Reach, TheOrderOfThingsInALevelLeavesNoTrace") {
  const geometry::Surfaces level = gardenLevel();
  const geometry::Surfaces ordered = geometry::inCanonicalOrder(level);
  REQUIRE(ordered.triangle.size() == level.triangle.size() - 4);  // the second of each plain square is a copy
  const base::Hash128 hash = hashOfSector(level, {0, 0}, 16.0);
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    const geometry::Surfaces other = inAnotherOrder(level, seed);
    CHECK(hashOfSector(other, {0, 0}, 16.0) == hash);
    geometry::Surfaces edited = other;  // out of reach
    for (auto& p : edited.position)
      if (p[0] > 200.0) p[1] += static_cast<double>(seed);
    CHECK(hashOfSector(edited, {0, 0}, 16.0) == hash);
    std::erase_if(edited.triangle,
                  [&](const geometry::Triangle& t) { return edited.position[t.vertex[0]][0] > 200.0; });
    CHECK(hashOfSector(edited, {0, 0}, 16.0) == hash);
  }
}

TEST_CASE("Reach, TreesAreToldApartAndWallsAreNot") {
  const auto hashOfTwo = [](geometry::Role role, bool apart) {
    geometry::Surfaces s = floorLevel();
    for (int i = 0; i < 2; ++i) {
      if (i == 0 || apart) s.object.push_back({"", role});
      addQuad(s, {10.0 + i, 0, 10}, {0, 0, 1}, {0, 2, 0}, 0);
      for (std::size_t t = s.triangle.size() - 2; t < s.triangle.size(); ++t)
        s.triangle[t].object = static_cast<std::uint32_t>(s.object.size() - 1);
    }
    s.uv.resize(s.position.size(), {0.5F, 0.5F});
    return hashOfSector(s, {0, 0}, 16.0);
  };
  CHECK(hashOfTwo(geometry::Role::fixed, true) == hashOfTwo(geometry::Role::fixed, false));
  CHECK_FALSE(hashOfTwo(geometry::Role::vegetation, true) == hashOfTwo(geometry::Role::vegetation, false));
}

TEST_CASE("Reach, EverythingThatABakeSeesCounts") {
  const base::Hash128 hash = hashOfSector(floorLevel(), {0, 0}, 0.0);
  const auto differs = [&](const char* what, auto change) {
    INFO(what);
    geometry::Surfaces s = floorLevel();
    change(s);
    CHECK_FALSE(hashOfSector(s, {0, 0}, 0.0) == hash);
  };
  differs("a vertex", [](auto& s) { s.position[0][1] += 1e-6; });
  differs("a coordinate", [](auto& s) { s.uv[3][0] = 0.5F; });
  differs("a colour", [](auto& s) { s.colour.assign(4, {1.0F, 1.0F, 0.5F}); });
  differs("an albedo", [](auto& s) { s.material[0].albedo.y = 0.25; });
  differs("an emission", [](auto& s) { s.material[0].emission.z = 1.0; });
  differs("a second side", [](auto& s) { s.material[0].double_sided = true; });
  differs("a cutoff", [](auto& s) { s.material[0].alpha_cutoff = 0.5; });
  differs("an alpha", [](auto& s) { s.material[0].alpha = 0.5; });
  differs("a texture's transform", [](auto& s) { s.material[0].uv_row[1][2] = 0.5; });
  differs("a texel", [](auto& s) { s.texture[0].rgba[2] = 31; });
  differs("a wrap across", [](auto& s) { s.texture[0].wrap_u = geometry::Texture::Wrap::mirrored; });
  differs("a wrap up", [](auto& s) { s.texture[0].wrap_v = geometry::Texture::Wrap::mirrored; });
  differs("a role", [](auto& s) { s.object[0].role = geometry::Role::vegetation; });
  differs("a directional light far off", [](auto& s) {
    s.light.push_back({{500, 5, 5}, Number3(1.0)});
    s.light[0].directional = true;
  });
  differs("a second texture", [](auto& s) { s.material[0].emission_texture = 0; });
  differs("a second texture's transform", [](auto& s) { s.material[0].emission_uv_row[1][2] = 0.5; });
  differs("a blend", [](auto& s) { s.material[0].blended = true; });
  differs("a transmission", [](auto& s) { s.material[0].transmission = 0.5; });
  differs("a light", [](auto& s) { s.light.push_back({{5, 5, 5}, Number3(1.0)}); });
  differs("a triangle the other way round",
          [](auto& s) { std::swap(s.triangle[0].vertex[1], s.triangle[0].vertex[2]); });
}

TEST_CASE("Reach, CopiesOfATriangleCountOnce") {
  const geometry::Surfaces level = floorLevel();
  geometry::Surfaces copies = level;
  for (int i = 0; i < 1000; ++i) copies.triangle.push_back(level.triangle[static_cast<std::size_t>(i % 2)]);
  CHECK(geometry::inCanonicalOrder(copies).triangle.size() == 2);
  CHECK(hashOfSector(copies, {0, 0}, 16.0) == hashOfSector(level, {0, 0}, 16.0));
  copies.object[0].role = geometry::Role::vegetation;
  CHECK(geometry::inCanonicalOrder(copies).triangle.size() == 1002);
}

}  // namespace welkin::tests
