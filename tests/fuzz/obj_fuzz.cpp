// SPDX-License-Identifier: Apache-2.0
// Fuzz target: an OBJ file and its libraries as exporters spell them. The bytes 1e hex divide the input into a.obj,
// a.mtl and "b b.mtl".
#include <algorithm>
#include <array>

#include "fuzz.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/image/image_module.h"

/// Loads the module before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  welkin::image::imageModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  static const fuzz::Folder kFolder;
  constexpr std::uint8_t kDivider = 0x1e;
  std::span<const std::uint8_t> rest(bytes, size);
  std::filesystem::path obj;
  for (const char* name : {"a.obj", "a.mtl", "b b.mtl"}) {
    const auto end = std::find(rest.begin(), rest.end(), kDivider);
    const auto length = static_cast<std::size_t>(end - rest.begin());
    const auto path = kFolder.write(name, rest.first(length));
    if (obj.empty()) obj = path;
    rest = rest.subspan(std::min(length + 1, rest.size()));
  }
  level::LevelFile level;
  level.geometry.push_back({obj, {}, geometry::Role::fixed, {}});
  geometry::Surfaces surfaces;
  if (!fuzz::accepts([&] { surfaces = loader::surfacesOf(loader::readScene(level), 1.0); })) return 0;
  for (const geometry::Triangle& t : surfaces.triangle) {
    fuzz::require(std::all_of(t.vertex.begin(), t.vertex.end(), [&](auto v) { return v < surfaces.position.size(); }),
                  "vertices are there");
    fuzz::require(t.material < surfaces.material.size(), "materials are there");
  }
  for (const auto& p : surfaces.position)
    fuzz::require(std::all_of(p.begin(), p.end(), [](float v) { return std::isfinite(v); }), "positions are finite");
  for (const geometry::Material& m : surfaces.material) {
    fuzz::require(fuzz::isFinite(m.albedo) && fuzz::isFinite(m.emission), "materials are finite");
    fuzz::require(
        std::min({m.albedo.x, m.albedo.y, m.albedo.z}) >= 0.0 && std::max({m.albedo.x, m.albedo.y, m.albedo.z}) <= 1.0,
        "albedo is within [0, 1]");
  }
  return 0;
}
