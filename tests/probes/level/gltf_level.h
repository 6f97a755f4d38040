// SPDX-License-Identifier: Apache-2.0
// Reads a glTF text as a level of one file, and checks how a wrong one is refused.
#pragma once

#include <catch2/catch.hpp>
#include <functional>

#include "probes/loader/read_scene.h"
#include "sky/base/error.h"
#include "tests/folder.h"
#include "tests/gltf_text.h"

namespace welkin::tests {

using nlohmann::json;

inline level::Scene sceneOf(const std::string& text, const std::function<void(level::GeometryEntry&)>& change = nullptr,
                            const char* name = "a.gltf") {
  const Folder folder;
  level::LevelFile level;
  level.geometry.push_back({folder.write(name, text), {}, geometry::Role::fixed, {}});
  if (change) change(level.geometry[0]);
  return loader::readScene(level);
}

inline void checkRefused(const std::string& text, base::ExitStatus status, const std::string& says,
                         const char* name = "a.gltf") {
  INFO(says);
  try {
    sceneOf(text, nullptr, name);
    FAIL("it was read");
  } catch (const base::Error& e) {
    INFO(e.what());
    CHECK(e.status() == status);
    CHECK_THAT(e.what(), Catch::Contains(name) && Catch::Contains(says));
  }
}

/// A square; `change` breaks it.
inline std::string squareText(const std::function<void(json&)>& change) {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()));
  change(gltf.json);
  return gltf.text();
}

inline void checkWrong(const std::function<void(json&)>& change, const std::string& says) {
  checkRefused(squareText(change), base::ExitStatus::content, says);
}

}  // namespace welkin::tests
