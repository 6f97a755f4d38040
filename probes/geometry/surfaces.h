// SPDX-License-Identifier: Apache-2.0
// A level for ray tracing: triangles in the world, with materials and textures. Metres, world axes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "probes/geometry/static_light.h"
#include "shared.h"

namespace welkin::geometry {

using f64::Number3;

/// The role of a surface in the bake and in the picture. Water is drawn and casts no shadow; an ignored surface is
/// neither baked nor drawn.
enum class Role { fixed, vegetation, water, ignored };

/// An image of base colours: sRGB-coded RGB and linear alpha, with rows from the top as in the file.
struct Texture {
  enum class Wrap : std::uint8_t { repeat, mirrored, clamped };
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
};

/// Texture coordinates from the vertex's: u = row[0] . (u, v, 1), v = row[1] . (u, v, 1) (KHR_texture_transform).
using UvRows = std::array<std::array<double, 3>, 2>;
inline constexpr UvRows kSameUv{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};

struct Material {
  Number3 albedo{0.5, 0.5, 0.5};  ///< linear, in [0, 1]; multiplies vertex colour and texture
  Number3 emission{0.0};          ///< radiance, scene units, >= 0
  int texture = -1;               ///< of base colours and alpha, index into Surfaces::texture; -1: none
  UvRows uv_row = kSameUv;
  int emission_texture = -1;  ///< its colours multiply the emission; -1: none
  UvRows emission_uv_row = kSameUv;
  double alpha = 1.0;         ///< multiplies the texture's alpha
  double alpha_cutoff = 0.0;  ///< there is no surface where alpha is below this; 0: opaque
  bool blended = false;       ///< alpha is the share of the surface that is there; cut at alpha_cutoff for places alone
  double transmission = 0.0;  ///< share of light that passes what is there, times the base colour, in [0, 1]
  bool double_sided = false;  ///< if false, the back is black and lets nothing through

  /// Whether light passes the surface, in part or in full.
  bool letsLightThrough() const { return blended || transmission > 0.0; }
  bool isTextured() const { return texture >= 0 || emission_texture >= 0; }
};

struct Triangle {
  std::array<std::uint32_t, 3> vertex;
  std::uint32_t material = 0;
  std::uint32_t object = 0;  ///< index into Surfaces::object
};

/// One placed node. Roles, vegetation boxes and messages refer to it.
struct Object {
  std::string name;
  Role role = Role::fixed;
};

struct Surfaces {
  std::vector<std::array<double, 3>> position;
  std::vector<std::array<float, 2>> uv;      ///< one per vertex, or empty
  std::vector<std::array<float, 3>> colour;  ///< one per vertex, linear, or empty
  std::vector<Triangle> triangle;
  std::vector<Material> material;
  std::vector<Texture> texture;
  std::vector<Object> object;
  std::vector<StaticLight> light;
  std::size_t dropped_triangles = 0;  ///< triangles without area or with numbers that are not finite
  std::vector<std::string> warning;   ///< features of the files that are ignored or read differently, with their names
  std::vector<std::filesystem::path> file;  ///< all files read: level.toml's geometry, buffers, materials, images
};

}  // namespace welkin::geometry
