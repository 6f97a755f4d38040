// SPDX-License-Identifier: Apache-2.0
// The whole level: materials, meshes and the nodes that place them, and its form as core glTF 2.0.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "generate/mesh.h"

namespace welkin::island {

struct Material {
  std::string name;
  Colour colour;
  double roughness = 0.9;
  bool doubleSided = false;
};

struct Node {
  std::string name;
  std::string mesh;
  Vec3 translation;
  double azimuth_rad = 0.0;  ///< clockwise from north, of the mesh's -z
  double pitch_rad = 0.0;    ///< raises the mesh's -z
  double roll_rad = 0.0;     ///< lowers the mesh's +x side
  double scale = 1.0;
  std::string role;  ///< extras.role: "static", "vegetation" or "water"
};

/// Bytes of a .gltf and of the .bin that it names.
struct GltfFiles {
  std::string json;
  std::vector<std::byte> binary;
};

class Scene {
 public:
  void addMaterial(const Material& material) { materials_.push_back(material); }
  void addMesh(const std::string& name, const Mesh& mesh) { meshes_[name] = {mesh, {}}; }
  /// The geometry of another mesh, stored once, with one material replaced.
  void addRepaintedMesh(const std::string& name, const std::string& original, const std::string& material,
                        const std::string& replacement);
  void addNode(const Node& node) { nodes_.push_back(node); }

  /// Throws Error(ExitStatus::internal) when a node or a mesh names a missing mesh or material.
  GltfFiles encode(const std::string& binaryName) const;

 private:
  struct Repainted {
    std::string original, material, replacement;
  };
  struct Entry {
    Mesh mesh;
    Repainted repainted;  ///< unused when `original` is empty
  };

  std::vector<Material> materials_;
  std::map<std::string, Entry> meshes_;
  std::vector<Node> nodes_;
};

}  // namespace welkin::island
