// SPDX-License-Identifier: Apache-2.0
// The level as a whole: materials, meshes and the nodes that place them, and its form as core glTF 2.0.
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

/// A .gltf and the .bin that it names.
struct GltfFiles {
  std::string json;
  std::vector<std::byte> binary;
};

class Scene {
 public:
  void addMaterial(const Material& material) { materials_.push_back(material); }
  void addMesh(const std::string& name, const Mesh& mesh) { meshes_[name] = {mesh, {}}; }
  /// The geometry of another mesh, stored once, with a material put in place of another.
  void addRepaintedMesh(const std::string& name, const std::string& original, const std::string& material,
                        const std::string& replacement);
  void addNode(const Node& node) { nodes_.push_back(node); }

  /// Throws Error(ExitStatus::internal) where a node or a mesh names what is not there.
  GltfFiles encode(const std::string& binaryName) const;

 private:
  struct Repainted {
    std::string original, material, replacement;
  };
  struct Entry {
    Mesh mesh;
    Repainted repainted;  ///< of no mesh when `original` is empty
  };

  std::vector<Material> materials_;
  std::map<std::string, Entry> meshes_;
  std::vector<Node> nodes_;
};

}  // namespace welkin::island
