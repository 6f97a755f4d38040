// SPDX-License-Identifier: Apache-2.0
// Levels, images and rays for tests that read geometry files.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/base/error.h"
#include "tests/folder.h"
#include "tests/gltf_text.h"

namespace welkin::tests {

using f64::Number3;
using Files = std::vector<std::pair<std::string, std::string>>;

inline std::string textOf(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// An uncompressed Targa file of red, green, blue and alpha, rows from the top.
inline std::string targa(int width, int height, const std::vector<unsigned char>& rgba) {
  const auto low = [](int n) { return static_cast<char>(n & 255); };
  std::string bytes = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, low(width), low(width >> 8), low(height), low(height >> 8)};
  bytes += {32, 0x28};
  for (std::size_t i = 0; i < rgba.size(); i += 4)
    for (const std::size_t c : {2, 1, 0, 3}) bytes += static_cast<char>(rgba[i + c]);
  return bytes;
}

/// A level with the first of `files`, which all lie in one folder.
inline level::LevelFile levelOf(const Folder& folder, const Files& files) {
  for (const auto& [name, bytes] : files) folder.write(name, bytes);
  level::LevelFile level;
  level.geometry.push_back({folder / files.front().first, {}, geometry::Role::fixed, {}});
  return level;
}

inline geometry::Surfaces surfacesOf(const Files& files, double luminance_unit = 1.0) {
  const Folder folder;
  return loader::surfacesOf(loader::readScene(levelOf(folder, files)), luminance_unit);
}

inline void checkSurfacesRefused(const Files& files, const std::vector<std::string>& says,
                                 base::ExitStatus status = base::ExitStatus::content) {
  try {
    surfacesOf(files);
    FAIL("it was read");
  } catch (const base::Error& e) {
    INFO(e.what());
    CHECK(e.status() == status);
    for (const std::string& part : says) CHECK_THAT(e.what(), Catch::Contains(part));
  }
}

/// The hit of a ray straight down at (x, z).
inline std::optional<geometry::Hit> below(const geometry::Tracer& tracer, double x, double z) {
  return tracer.closest({x, 10.0, z}, {0.0, -1.0, 0.0}, 100.0);
}

inline void checkNear(const Number3& is, const Number3& must, double tolerance) {
  INFO(is.x << " " << is.y << " " << is.z << ", must be " << must.x << " " << must.y << " " << must.z);
  for (int i = 0; i < 3; ++i) CHECK(is[i] == Approx(must[i]).margin(tolerance).epsilon(0));
}

}  // namespace welkin::tests
