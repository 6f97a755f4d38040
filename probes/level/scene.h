// SPDX-License-Identifier: Apache-2.0
// A level's surfaces as its files store them: one vertex list and one index list, placed by instances. Metres, world
// axes.
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
  float uv[2];      ///< of the base colour's texture, v from the top; 0 without a texture
};

/// One placing of a mesh, as a shader reads it: the rows of the transform, each ending with its translation.
struct Instance {
  float row[3][4];
  float albedo[4];  ///< rgb, linear; alpha 0
};

/// The same placing for rays.
struct Placing {
  geometry::Affine transform;
  uint32_t object = 0;  ///< index into Scene::objects
};

/// An image as its file stores it, still encoded.
struct TextureSource {
  std::string name;  ///< for messages: the image's file, or the file and the part that contain it
  std::vector<std::byte> bytes;
  geometry::Texture::Wrap wrap_u = geometry::Texture::Wrap::repeat;
  geometry::Texture::Wrap wrap_v = geometry::Texture::Wrap::repeat;
};

struct SceneMaterial {
  geometry::Material surface;      ///< its texture is an index into Scene::textures
  int mean_emission_texture = -1;  ///< index into Scene::textures; its mean colour multiplies the emission; -1: none
  int mean_transmission_texture = -1;  ///< the mean of its red multiplies the transmission; -1: none
  double roughness = 1.0;              ///< 0: a mirror
  double metallic = 0.0;               ///< share of the surface that is metal
  int mean_metal_texture = -1;  ///< index into Scene::metal_textures; the means of its green and blue multiply both
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
  bool mirrored = false;              ///< triangles turn the other way round
  uint32_t material = 0;              ///< index into Scene::materials
  std::size_t dropped_triangles = 0;  ///< of the piece: without area or not finite, so without indices
};

struct Bounds {
  f64::Number3 low{1e30, 1e30, 1e30};
  f64::Number3 high{-1e30, -1e30, -1e30};

  bool empty() const { return !(low.x <= high.x); }
  void add(const f64::Number3& p);
};

inline constexpr std::uint32_t kNoContact = 0xffffffff;

struct Scene {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
  std::vector<Instance> instances;
  std::vector<Placing> placings;  ///< one per instance
  std::vector<Draw> draws;
  std::vector<SceneMaterial> materials;
  std::vector<TextureSource> textures;
  std::vector<TextureSource> metal_textures;  ///< of roughness and metal, for pictures alone: no bake reads them
  std::vector<geometry::Object> objects;
  std::vector<geometry::StaticLight> lights;  ///< in cd, or lux for directional ones
  std::vector<std::string> warnings;          ///< features of the files that are ignored or read differently
  std::vector<std::filesystem::path> files;   ///< all files read
  Bounds bounds;                              ///< of everything but the water
  Bounds water;                               ///< empty without water
  double least_roughness = 1.0;               ///< of all materials, water included; 0: a mirror
  /// Contact factors of placed vertices, in steps of 1 / 170, and by instance the first of its own; empty: none. An
  /// instance without has kNoContact.
  std::vector<std::uint8_t> contact;
  std::vector<std::uint32_t> first_contact;
};

}  // namespace welkin::level
