// SPDX-License-Identifier: Apache-2.0
// Reads a level's geometry, file by file.
#include "probes/level/scene.h"

#include <algorithm>
#include <cctype>

#include "sky/error.h"

namespace welkin::probes {

void Bounds::add(const f64::Number3& p) {
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], p[i]);
    high[i] = std::max(high[i], p[i]);
  }
}

Scene readScene(const LevelFile& level) {
  Scene scene;
  for (const GeometryEntry& entry : level.geometry) {
    std::string suffix = entry.path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix != ".gltf" && suffix != ".glb")
      throw Error(ExitStatus::content, entry.path.string() + ": levels are drawn from glTF 2.0, .gltf or .glb");
    addGltf(entry, scene);
  }
  if (scene.draws.empty())
    throw Error(ExitStatus::content, level.geometry.front().path.string() + ": the level holds nothing to draw");
  return scene;
}

}  // namespace welkin::probes
