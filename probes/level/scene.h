// SPDX-License-Identifier: Apache-2.0
// A level's surfaces as triangles: one vertex and one index list, drawn by instances. Metres, world axes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "probes/level/level_file.h"

namespace welkin::probes {

struct Vertex {
  float position[3];
  float normal[3];  ///< unit, in the mesh's own axes
  float colour[3];  ///< linear; the albedo is this times the instance's colour
};

/// One placing of a mesh. The rows of the transform, each with its translation last; as a shader reads it.
struct Instance {
  float row[3][4];
  float albedo[4];  ///< rgb, linear; alpha 0
};

/// Consecutive instances of one piece of a mesh.
struct Draw {
  uint32_t first_index = 0;
  uint32_t index_count = 0;
  int32_t vertex_offset = 0;
  uint32_t first_instance = 0;
  uint32_t instance_count = 0;
  Role role = Role::fixed;
  bool double_sided = false;
  bool mirrored = false;  ///< its triangles turn the other way round
};

struct Bounds {
  f64::Number3 low{1e30, 1e30, 1e30};
  f64::Number3 high{-1e30, -1e30, -1e30};

  bool empty() const { return !(low.x <= high.x); }
  void add(const f64::Number3& p);
};

struct Scene {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
  std::vector<Instance> instances;
  std::vector<Draw> draws;
  Bounds bounds;                 ///< of all but the water
  Bounds water;                  ///< empty without water
  double least_roughness = 1.0;  ///< of all materials, water included; 0: a mirror
};

/// Reads every geometry of a level; at least one draw comes of it. Throws Error as readLevelFile does, naming the file
/// and the part of it.
Scene readScene(const LevelFile& level);

/// Adds what a glTF file holds.
void addGltf(const GeometryEntry& entry, Scene& scene);

}  // namespace welkin::probes
