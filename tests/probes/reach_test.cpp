// SPDX-License-Identifier: Apache-2.0
// What a sector's bake reads of a level says the same whatever lies beyond its reach.
#include "probes/reach.h"

#include <catch2/catch.hpp>

#include "rooms.h"

namespace welkin::tests {
namespace {

using namespace probes;

Hash128 hashOfSector(const Surfaces& level, SectorId sector, double reach_m) {
  Hasher hasher;
  probes::addTo(hasher, surfacesWithin(level, columnOf(sector, reach_m)), textureHashes(level));
  return hasher.digest();
}

/// A textured floor in sector 0_0.
Surfaces floorLevel() {
  Surfaces s;
  s.texture.push_back({1, 1, {10, 20, 30, 255}, Texture::Wrap::repeat, Texture::Wrap::clamped});
  const auto material = addMaterial(s, Number3(0.5));
  s.material[material].texture = 0;
  addQuad(s, {1, 0, 1}, {0, 0, 60}, {60, 0, 0}, material);
  s.uv.assign(s.position.size(), {0.25F, 0.75F});
  return s;
}

}  // namespace

TEST_CASE("Reach, EndsAtItsDistance") {
  const auto trianglesAt = [](double x, double reach_m) {
    Surfaces s;
    addQuad(s, {x, 0, 10}, {0, 0, 1}, {1, 0, 0}, addMaterial(s, Number3(0.5)));
    return surfacesWithin(s, columnOf({1, 0}, reach_m)).surfaces.triangle.size();  // x 64 to 128
  };
  CHECK(trianglesAt(127.5, 0.0) == 2);
  CHECK(trianglesAt(128.5, 0.0) == 0);
  CHECK(trianglesAt(191.5, 64.0) == 2);
  CHECK(trianglesAt(192.5, 64.0) == 0);
  CHECK(trianglesAt(-0.5, 64.0) == 2);
  CHECK(trianglesAt(-1.5, 64.0) == 0);
}

TEST_CASE("Reach, WhatLiesBeyondChangesNothing") {
  const Surfaces level = floorLevel();
  const Hash128 hash = hashOfSector(level, {0, 0}, 16.0);
  Surfaces more;  // other things first, so that every index differs
  more.texture.push_back({1, 1, {1, 2, 3, 255}, Texture::Wrap::repeat, Texture::Wrap::repeat});
  more.object.push_back({"far away", Role::vegetation});
  addQuad(more, {500, 0, 1}, {0, 0, 60}, {60, 0, 0}, addMaterial(more, Number3(0.1)));
  const auto vertices = static_cast<std::uint32_t>(more.position.size());
  more.uv.assign(vertices, {0.5F, 0.5F});
  more.colour.assign(vertices, {0.1F, 0.2F, 0.3F});
  for (Material m : level.material) {
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
  for (Triangle t : level.triangle) {
    for (auto& v : t.vertex) v += vertices;
    t.material += 1;
    t.object += 1;
    more.triangle.push_back(t);
  }
  more.light.push_back({{500, 1, 1}, Number3(1.0)});
  more.spot.push_back({1, 1, 500});
  CHECK(hashOfSector(more, {0, 0}, 16.0) == hash);
  CHECK_FALSE(hashOfSector(more, {0, 0}, 1000.0) == hash);
  const Surfaces near = withTexels(surfacesWithin(more, columnOf({0, 0}, 16.0)), more);
  CHECK(near.texture.size() == 1);
  CHECK(near.texture[0].rgba == level.texture[0].rgba);
  CHECK(near.uv == level.uv);
  CHECK(near.colour.empty());
}

TEST_CASE("Reach, EverythingThatABakeSeesCounts") {
  const Hash128 hash = hashOfSector(floorLevel(), {0, 0}, 0.0);
  const auto differs = [&](const char* what, auto change) {
    INFO(what);
    Surfaces s = floorLevel();
    change(s);
    CHECK_FALSE(hashOfSector(s, {0, 0}, 0.0) == hash);
  };
  differs("a vertex", [](auto& s) { s.position[0][1] += 1e-6F; });
  differs("a coordinate", [](auto& s) { s.uv[3][0] = 0.5F; });
  differs("a colour", [](auto& s) { s.colour.assign(4, {1.0F, 1.0F, 0.5F}); });
  differs("an albedo", [](auto& s) { s.material[0].albedo.y = 0.25; });
  differs("an emission", [](auto& s) { s.material[0].emission.z = 1.0; });
  differs("a second side", [](auto& s) { s.material[0].double_sided = true; });
  differs("a cutoff", [](auto& s) { s.material[0].alpha_cutoff = 0.5; });
  differs("an alpha", [](auto& s) { s.material[0].alpha = 0.5; });
  differs("a texture's transform", [](auto& s) { s.material[0].uv_row[1][2] = 0.5; });
  differs("a texel", [](auto& s) { s.texture[0].rgba[2] = 31; });
  differs("a wrap across", [](auto& s) { s.texture[0].wrap_u = Texture::Wrap::mirrored; });
  differs("a wrap up", [](auto& s) { s.texture[0].wrap_v = Texture::Wrap::mirrored; });
  differs("a role", [](auto& s) { s.object[0].role = Role::vegetation; });
  differs("a spot light", [](auto& s) { s.spot.push_back({5, 5, 5}); });
  differs("a light", [](auto& s) { s.light.push_back({{5, 5, 5}, Number3(1.0)}); });
  differs("a triangle the other way round",
          [](auto& s) { std::swap(s.triangle[0].vertex[1], s.triangle[0].vertex[2]); });
}

}  // namespace welkin::tests
