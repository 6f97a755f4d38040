// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a level's geometry. The first byte selects glTF, binary glTF, OBJ or MTL.
#include <algorithm>

#include "fuzz.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/image/image_module.h"

namespace welkin::fuzz {
namespace {

constexpr const char* kNames[] = {"a.gltf", "a.glb", "a.obj", "a.mtl"};
constexpr std::string_view kObjOfTheMtl =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 0 1\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nusemtl b\nf 1 2 3\n";

void requireWhole(const geometry::Surfaces& s) {
  const std::size_t vertices = s.position.size();
  require(s.uv.empty() || s.uv.size() == vertices, "every vertex has texture coordinates, or none has");
  require(s.colour.empty() || s.colour.size() == vertices, "every vertex has a colour, or none has");
  for (const auto& p : s.position)
    require(std::all_of(p.begin(), p.end(), [](float v) { return std::isfinite(v); }), "positions are finite");
  for (const geometry::Triangle& t : s.triangle) {
    require(std::all_of(t.vertex.begin(), t.vertex.end(), [&](std::uint32_t v) { return v < vertices; }),
            "vertices are there");
    require(t.material < s.material.size() && t.object < s.object.size(), "materials and objects are there");
  }
  for (const geometry::Material& m : s.material) {
    require(std::max(m.texture, m.emission_texture) < static_cast<int>(s.texture.size()), "textures are there");
    require(m.transmission >= 0.0 && m.transmission <= 1.0, "transmission is within [0, 1]");
    require(isFinite(m.albedo) && isFinite(m.emission) && std::isfinite(m.alpha), "materials are finite");
    require(
        std::min({m.albedo.x, m.albedo.y, m.albedo.z}) >= 0.0 && std::max({m.albedo.x, m.albedo.y, m.albedo.z}) <= 1.0,
        "albedo is within [0, 1]");
    for (const auto& row : m.uv_row)
      require(std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); }), "transforms are finite");
  }
  for (const geometry::Texture& t : s.texture)
    require(t.rgba.size() == 4 * static_cast<std::size_t>(t.width) * static_cast<std::size_t>(t.height),
            "every texel is there");
  for (const geometry::StaticLight& light : s.light) {
    require(isFinite(light.position) && isFinite(light.intensity), "lights are finite");
    require(std::abs(dot(light.axis, light.axis) - 1.0) < 1e-9, "lights shine along unit vectors");
    require(std::isfinite(light.inverse_range4) && std::isfinite(light.cone_scale) && std::isfinite(light.cone_offset),
            "ranges and cones are finite");
  }
}

}  // namespace
}  // namespace welkin::fuzz

/// Loads the module before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  welkin::image::imageModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  static const fuzz::Folder kFolder;
  if (size == 0) return 0;
  const std::size_t kind = bytes[0] % std::size(fuzz::kNames);
  auto path = kFolder.write(fuzz::kNames[kind], {bytes + 1, size - 1});
  if (kind == 3) {
    const auto* obj = reinterpret_cast<const std::uint8_t*>(fuzz::kObjOfTheMtl.data());
    path = kFolder.write("of_the_mtl.obj", {obj, fuzz::kObjOfTheMtl.size()});
  }
  level::LevelFile level;
  level.geometry.push_back({path, {}, geometry::Role::fixed, {}});
  geometry::Surfaces surfaces;
  if (fuzz::accepts([&] { surfaces = loader::surfacesOf(loader::readScene(level), 1.0); }))
    fuzz::requireWhole(surfaces);
  return 0;
}
