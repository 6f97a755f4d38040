// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: vertices, and polygons by object and material. Own, because tinyobjloader and assimp read what is no
// number as 0, and cannot say in which line anything is wrong. "Object Files (.obj)", Alias|Wavefront, 1995, B1.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace welkin::loader {

/// Places of position, texture coordinate and normal in their lists; -1: none.
struct ObjCorner {
  int32_t position = -1;
  int32_t uv = -1;
  int32_t normal = -1;
};

/// The triangles of one object with one material, three corners each.
struct ObjPart {
  std::string object;    ///< of the last `o` or `g` before
  std::string material;  ///< of `usemtl`; empty: none
  std::vector<ObjCorner> corners;
};

struct ObjFile {
  std::vector<std::array<float, 3>> position;
  std::vector<std::array<float, 3>> colour;  ///< one a position, linear; empty: none
  std::vector<std::array<float, 2>> uv;      ///< v from the bottom
  std::vector<std::array<float, 3>> normal;
  std::vector<ObjPart> parts;
  std::vector<std::string> material_files;  ///< of `mtllib`
};

/// Reads the file; polygons become triangles. Numbers need not be finite. Points, lines, curves, smoothing and
/// everything else that is no polygon is left out. Throws Error: `file` when it cannot be read, `content` naming the
/// line.
ObjFile readObj(const std::filesystem::path& path);

}  // namespace welkin::loader
