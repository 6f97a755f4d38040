// SPDX-License-Identifier: Apache-2.0
// Reads Wavefront OBJ: vertices, and polygons by object and material. "Object Files (.obj)", Alias|Wavefront, 1995, B1.
// This is our own reader: tinyobjloader and assimp read words that are no numbers as 0, and cannot name the line of an
// error.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace welkin::obj {

/// Indices of position, texture coordinate and normal in their lists; -1: none.
struct ObjCorner {
  int32_t position = -1;
  int32_t uv = -1;
  int32_t normal = -1;
};

/// The triangles of one object with one material, three corners each.
struct ObjPart {
  std::string object;    ///< name from the last `o` or `g` before
  std::string material;  ///< name from `usemtl`; empty: none
  std::vector<ObjCorner> corners;
};

struct ObjFile {
  std::vector<std::array<double, 3>> position;
  std::vector<std::array<float, 3>> colour;  ///< one per position, linear; empty: none
  std::vector<std::array<float, 2>> uv;      ///< v from the bottom
  std::vector<std::array<float, 3>> normal;
  std::vector<ObjPart> parts;
  std::vector<std::string> libraries;  ///< what follows each `mtllib`, each once: one or several file names
  std::string unknown_words;           ///< keywords that are not read, with their lines, for a warning; empty: none
};

/// Reads the file; polygons become triangles. Numbers need not be finite. Points, lines and smoothing are skipped, and
/// keywords may have any case. Throws Error: `file` if the file cannot be read, `content` naming the line.
ObjFile readObj(const std::filesystem::path& path);

}  // namespace welkin::obj
