// SPDX-License-Identifier: Apache-2.0
// Turns a glTF model's nodes into a scene: each mesh once, and an instance for each node that places it.
#include "probes/gltf/gltf_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "probes/gltf/accessor.h"
#include "probes/gltf/gltf_file.h"
#include "probes/gltf/gltf_instancing.h"
#include "probes/gltf/gltf_light.h"
#include "probes/gltf/gltf_mesh.h"
#include "probes/gltf/gltf_node.h"

namespace welkin::gltf {
namespace {

class GltfSource : public level::GeometrySource {
 public:
  GltfSource(const std::filesystem::path& path, level::SceneBuilder& builder)
      : builder_(builder),
        model_(readGltf(path, builder.scene().files, builder.scene().warnings)),
        reader_(model_, path.string()),
        meshes_(model_, reader_, builder) {
    warn(std::any_of(model_.nodes.begin(), model_.nodes.end(),
                     [](const tinygltf::Node& node) { return node.skin >= 0 && node.mesh >= 0; }),
         "skins: skinned meshes stand as their nodes place them");
    const auto& used = model_.extensionsUsed;  // tinygltf drops channels of KHR_animation_pointer
    const bool has_pointers =
        !model_.animations.empty() && std::find(used.begin(), used.end(), "KHR_animation_pointer") != used.end();
    warn(has_pointers || std::any_of(model_.animations.begin(), model_.animations.end(),
                                     [](const tinygltf::Animation& animation) { return !animation.channels.empty(); }),
         "animations: what they move stands as the nodes and weights of the file say");
  }

  void place(const level::GeometryEntry& entry) override {
    visited_.assign(model_.nodes.size(), false);
    placeTrees(roots(), entry);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < visited_.size(); ++i)
      if (visited_[i]) names.push_back(model_.nodes[i].name);
    builder_.warnOfIdlePatterns(entry, names);
  }

 private:
  void warn(bool holds, const std::string& what) {
    if (holds) builder_.scene().warnings.push_back(fmt::format("{}: {}", reader_.file(), what));
  }

  /// Root nodes of the file's scene, or without scenes the nodes that have no parent.
  std::vector<int> roots() const {
    if (!model_.scenes.empty()) {
      const int scene = model_.defaultScene < 0 ? 0 : model_.defaultScene;
      if (static_cast<std::size_t>(scene) >= model_.scenes.size())
        reader_.refuse("scene", fmt::format("{} is none of the {}", scene, model_.scenes.size()));
      return model_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes)
      for (const int c : node.children)
        if (c >= 0 && static_cast<std::size_t>(c) < child.size()) child[static_cast<std::size_t>(c)] = true;
    std::vector<int> found;
    for (std::size_t i = 0; i < child.size(); ++i)
      if (!child[i]) found.push_back(static_cast<int>(i));
    return found;
  }

  /// A node that waits to be placed.
  struct Waiting {
    int node;
    geometry::Affine parent;
    geometry::Role inherited;
    bool visible;   ///< KHR_node_visibility: a node is if it and all above it are
    bool left_out;  ///< it, or a node above it, fits ignore_nodes
    int depth;
  };

  /// Places the nodes below some roots, parents first and in the order of their lists. It does not recurse, so that a
  /// small stack is enough.
  void placeTrees(const std::vector<int>& roots, const level::GeometryEntry& entry) {
    std::vector<Waiting> waiting;
    const auto add = [&](const std::vector<int>& nodes, Waiting like) {
      for (std::size_t i = nodes.size(); i-- > 0;) {
        like.node = nodes[i];
        waiting.push_back(like);
      }
    };
    add(roots, {-1, entry.transform, entry.role, true, false, 0});
    while (!waiting.empty()) {
      const Waiting next = waiting.back();
      waiting.pop_back();
      const Waiting children = placeNode(next, entry);
      add(model_.nodes[static_cast<std::size_t>(next.node)].children, children);
    }
  }

  /// Returns what the node's children inherit.
  Waiting placeNode(const Waiting& at, const level::GeometryEntry& entry) {
    const int index = at.node;
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
      reader_.refuse("nodes", fmt::format("{} is none of the {}", index, model_.nodes.size()));
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    const std::string name = nodeName(index, node);
    if (visited_[static_cast<std::size_t>(index)]) reader_.refuse(name, "has two parents, or is its own");
    visited_[static_cast<std::size_t>(index)] = true;
    constexpr int kDeepest = 256;
    if (at.depth > kDeepest) reader_.refuse(name, fmt::format("is more than {} nodes deep", kDeepest));
    const geometry::Affine transform = at.parent * nodeTransform(index, node, reader_);
    const geometry::Role role = nodeRole(index, node, entry, at.inherited, reader_);
    const bool visible = at.visible && isVisible(node);
    const bool left_out = at.left_out || level::matchesAny(entry.ignore_nodes, node.name);
    if (visible && !left_out && role != geometry::Role::ignored) {
      if (node.mesh >= 0) placeMesh(index, name, transform, role, entry.albedo);
      if (const tinygltf::Light* light = nodeLight(index, node, model_, reader_)) placeLight(*light, name, transform);
    }
    return {index, transform, role, visible, left_out, at.depth + 1};
  }

  void placeMesh(int index, const std::string& who, const geometry::Affine& transform, geometry::Role role,
                 const f64::Number3& albedo) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size())
      reader_.refuse(who, fmt::format("mesh {} is none of the {}", node.mesh, model_.meshes.size()));
    const std::vector<level::MeshPiece>& pieces = meshes_.pieces(node.mesh, node.weights);
    const uint32_t object = builder_.addObject(node.name.empty() ? who : node.name, role);
    for (const geometry::Affine& instance : instancesOf(index, node, reader_))
      for (const level::MeshPiece& piece : pieces) builder_.place(piece, transform * instance, object, albedo);
  }

  void placeLight(const tinygltf::Light& light, const std::string& who, const geometry::Affine& transform) {
    const auto placed = readLight(light, transform, who, reader_);
    warn(!placed, fmt::format("{}: its light is left out: its scale leaves no direction to shine in", who));
    if (!placed) return;
    warn(
        placed->directional,
        fmt::format("{}: a directional light shines at every hour, beside the sun of the sky; extras.role = \"ignore\" "
                    "leaves it out",
                    who));
    builder_.scene().lights.push_back(*placed);
  }

  level::SceneBuilder& builder_;
  tinygltf::Model model_;
  AccessorReader reader_;
  GltfMeshes meshes_;
  std::vector<bool> visited_;
};

}  // namespace

std::unique_ptr<level::GeometrySource> readGltfSource(const std::filesystem::path& path, level::SceneBuilder& builder) {
  return std::make_unique<GltfSource>(path, builder);
}

}  // namespace welkin::gltf
