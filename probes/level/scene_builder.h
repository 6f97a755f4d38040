// SPDX-License-Identifier: Apache-2.0
// Builds a scene from pieces of any file and their placings.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "probes/level/mesh_piece.h"
#include "probes/level/scene.h"

namespace welkin::level {

/// Whether a name fits a pattern in which * stands for any run of characters, or one of several.
bool matchesPattern(const std::string& pattern, const std::string& name);
bool matchesAny(const std::vector<std::string>& patterns, const std::string& name);

class SceneBuilder {
 public:
  /// The scene as read so far; finish() adds instances and draws.
  Scene& scene() { return scene_; }

  uint32_t addMaterial(SceneMaterial material);
  /// Adds an image and returns its index, or returns the index of an equal image with the same wrapping.
  int addTexture(TextureSource source);
  uint32_t addObject(std::string name, geometry::Role role);

  /// Places a piece. `albedo` is for a piece with neither a material nor colours. A transform without volume, which
  /// animations use to hide a node, places nothing; finish() warns of it.
  void place(const MeshPiece& piece, const geometry::Affine& transform, uint32_t object, const f64::Number3& albedo);

  /// Warns about each pattern in the entry's vegetation_nodes and ignore_nodes that matches none of the names.
  void warnOfIdlePatterns(const GeometryEntry& entry, const std::vector<std::string>& names);

  /// Returns the scene, with the placings of one piece as consecutive instances.
  Scene finish();

 private:
  struct Placed {
    const MeshPiece* piece;
    uint32_t material;
    geometry::Role role;
    bool mirrored;
    Placing placing;
  };
  uint32_t bareMaterial(const f64::Number3& albedo);

  Scene scene_;
  std::vector<Placed> placed_;
  std::vector<uint32_t> without_volume_;  // indices of objects
  std::map<std::vector<double>, uint32_t> bare_;
  std::map<std::pair<std::string, std::pair<geometry::Texture::Wrap, geometry::Texture::Wrap>>, int> textures_;
};

}  // namespace welkin::level
