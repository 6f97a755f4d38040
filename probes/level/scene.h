// SPDX-License-Identifier: Apache-2.0
// A level's surfaces as its files hold them: one vertex and one index list, placed by instances. Metres, world axes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "probes/geometry/surfaces.h"
#include "probes/level/level_file.h"

namespace welkin::level {

struct Vertex {
  float position[3];
  float normal[3];  ///< unit, in the mesh's own axes
  float colour[3];  ///< linear; the albedo is this times the instance's colour
  float uv[2];      ///< of the base colour's texture, v from the top; 0 without one
};

/// One placing of a mesh. The rows of the transform, each with its translation last; as a shader reads it.
struct Instance {
  float row[3][4];
  float albedo[4];  ///< rgb, linear; alpha 0
};

/// The same placing for rays.
struct Placing {
  geometry::Affine transform;
  uint32_t object = 0;  ///< of Scene::objects
};

/// An image as its file holds it, still encoded.
struct TextureSource {
  std::string name;  ///< for messages: its file, or the file and the part that hold it
  std::vector<std::byte> bytes;
  geometry::Texture::Wrap wrap_u = geometry::Texture::Wrap::repeat;
  geometry::Texture::Wrap wrap_v = geometry::Texture::Wrap::repeat;
};

struct SceneMaterial {
  geometry::Material surface;  ///< its texture is of Scene::textures
  int emissive_texture = -1;   ///< of Scene::textures: its mean colour multiplies the emission; -1: none
  double roughness = 1.0;      ///< 0: a mirror
};

/// Consecutive instances of one piece of a mesh.
struct Draw {
  uint32_t first_index = 0;
  uint32_t index_count = 0;
  int32_t vertex_offset = 0;
  uint32_t first_instance = 0;
  uint32_t instance_count = 0;
  geometry::Role role = geometry::Role::fixed;
  bool double_sided = false;
  bool mirrored = false;              ///< its triangles turn the other way round
  uint32_t material = 0;              ///< of Scene::materials
  std::size_t dropped_triangles = 0;  ///< of the piece, without area or not finite: they are not among its indices
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
  std::vector<Placing> placings;  ///< one an instance
  std::vector<Draw> draws;
  std::vector<SceneMaterial> materials;
  std::vector<TextureSource> textures;
  std::vector<geometry::Object> objects;
  std::vector<geometry::PointLight> lights;
  std::vector<f64::Number3> spots;           ///< places of spot lights
  std::vector<std::string> warnings;         ///< what the files hold that has no effect here, or another one
  std::vector<std::filesystem::path> files;  ///< all that were read
  Bounds bounds;                             ///< of all but the water
  Bounds water;                              ///< empty without water
  double least_roughness = 1.0;              ///< of all materials, water included; 0: a mirror
};

}  // namespace welkin::level
