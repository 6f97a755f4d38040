// SPDX-License-Identifier: Apache-2.0
// From a glTF model's nodes to a scene: every mesh once, every node that places it an instance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "probes/level/accessor.h"
#include "probes/level/gltf_file.h"
#include "probes/level/gltf_mesh.h"
#include "probes/level/scene.h"

namespace welkin::probes {
namespace {

using f64::Number3;

struct Placing {
  const GltfPiece* piece;
  Role role;
  bool mirrored;
  Instance instance;
};

/// Whether a name fits a pattern in which * stands for any run of characters.
bool matches(const std::string& pattern, const std::string& name) {
  std::size_t p = 0;
  std::size_t n = 0;
  std::size_t star = std::string::npos;
  std::size_t after_star = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      after_star = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (star != std::string::npos) {
      p = star + 1;
      n = ++after_star;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string::npos;
}

class GltfReader {
 public:
  GltfReader(const GeometryEntry& entry, Scene& scene)
      : entry_(entry),
        scene_(scene),
        model_(readGltf(entry.path)),
        reader_(model_, entry.path.string()),
        meshes_(model_, reader_, entry.albedo, scene) {}

  void read() {
    visited_.assign(model_.nodes.size(), false);
    if (model_.scenes.empty()) {
      for (const int root : roots()) readNode(root, entry_.transform, entry_.role, 0);
    } else {
      const int scene = model_.defaultScene < 0 ? 0 : model_.defaultScene;
      if (static_cast<std::size_t>(scene) >= model_.scenes.size())
        reader_.refuse("scene", fmt::format("{} is none of the {}", scene, model_.scenes.size()));
      for (const int root : model_.scenes[static_cast<std::size_t>(scene)].nodes)
        readNode(root, entry_.transform, entry_.role, 0);
    }
    emit();
  }

 private:
  std::vector<int> roots() const {
    std::vector<bool> child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes)
      for (const int c : node.children)
        if (c >= 0 && static_cast<std::size_t>(c) < child.size()) child[static_cast<std::size_t>(c)] = true;
    std::vector<int> found;
    for (std::size_t i = 0; i < child.size(); ++i)
      if (!child[i]) found.push_back(static_cast<int>(i));
    return found;
  }

  static std::string nameOf(int index, const tinygltf::Node& node) {
    return fmt::format("node {} \"{}\"", index, node.name.substr(0, 60));
  }

  Affine transformOf(int index, const tinygltf::Node& node) const {
    const auto check = [&](const std::vector<double>& numbers, std::size_t size, const char* what) {
      if (!numbers.empty() && numbers.size() != size)
        reader_.refuse(nameOf(index, node), fmt::format("{} has {} numbers, must have {}", what, numbers.size(), size));
      for (const double number : numbers)
        if (!(std::abs(number) <= 1e9)) reader_.refuse(nameOf(index, node), fmt::format("{} holds {}", what, number));
    };
    check(node.matrix, 16, "matrix");
    check(node.translation, 3, "translation");
    check(node.rotation, 4, "rotation");
    check(node.scale, 3, "scale");
    const auto& m = node.matrix;
    if (!m.empty()) return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
    const auto vector = [](const std::vector<double>& v, double otherwise) {
      return v.empty() ? Number3(otherwise) : Number3(v[0], v[1], v[2]);
    };
    double rotation[4] = {0.0, 0.0, 0.0, 1.0};
    if (!node.rotation.empty()) {
      double length = 0.0;
      for (const double q : node.rotation) length += q * q;
      if (!(length > 0.0)) reader_.refuse(nameOf(index, node), "rotation is zero");
      for (std::size_t i = 0; i < 4; ++i) rotation[i] = node.rotation[i] / std::sqrt(length);
    }
    return fromTrs(vector(node.translation, 0.0), rotation, vector(node.scale, 1.0));
  }

  /// extras.role, else vegetation_nodes, else the parent's.
  Role roleFor(int index, const tinygltf::Node& node, Role inherited) const {
    if (node.extras.Has("role")) {
      const tinygltf::Value& value = node.extras.Get("role");
      const std::string name = value.IsString() ? value.Get<std::string>() : "";
      const auto role = roleOf(name);
      if (!role)
        reader_.refuse(nameOf(index, node),
                       fmt::format("extras.role = \"{}\": must be static, vegetation, water or ignore", name));
      return *role;
    }
    for (const std::string& pattern : entry_.vegetation_nodes)
      if (matches(pattern, node.name)) return Role::vegetation;
    return inherited;
  }

  void readNode(int index, const Affine& parent, Role inherited, int depth) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.nodes.size())
      reader_.refuse("nodes", fmt::format("{} is none of the {}", index, model_.nodes.size()));
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
    if (visited_[static_cast<std::size_t>(index)])
      reader_.refuse(nameOf(index, node), "has two parents, or is its own");
    visited_[static_cast<std::size_t>(index)] = true;
    constexpr int kDeepest = 256;
    if (depth > kDeepest) reader_.refuse(nameOf(index, node), fmt::format("is more than {} nodes deep", kDeepest));
    const Affine transform = parent * transformOf(index, node);
    const Role role = roleFor(index, node, inherited);
    if (node.mesh >= 0 && role != Role::ignored) place(node.mesh, nameOf(index, node), transform, role);
    for (const int child : node.children) readNode(child, transform, role, depth + 1);
  }

  void place(int mesh, const std::string& who, const Affine& t, Role role) {
    if (static_cast<std::size_t>(mesh) >= model_.meshes.size())
      reader_.refuse(who, fmt::format("mesh {} is none of the {}", mesh, model_.meshes.size()));
    if (t.determinant() == 0.0) return;  // scaled to nothing: how animations hide a node
    for (const GltfPiece& piece : meshes_.pieces(mesh)) {
      Instance instance{};
      for (int row = 0; row < 3; ++row) {
        const double numbers[4] = {t.x[row], t.y[row], t.z[row], t.translation[row]};
        for (int i = 0; i < 4; ++i) instance.row[row][i] = static_cast<float>(numbers[i]);
        instance.albedo[row] = static_cast<float>(piece.albedo[row]);
      }
      placings_.push_back({&piece, role, t.determinant() < 0.0, instance});
      scene_.least_roughness = std::min(scene_.least_roughness, piece.roughness);
      Bounds& bounds = role == Role::water ? scene_.water : scene_.bounds;
      for (int corner = 0; corner < 8; ++corner)
        bounds.add(t.point({(corner & 1) != 0 ? piece.bounds.high.x : piece.bounds.low.x,
                            (corner & 2) != 0 ? piece.bounds.high.y : piece.bounds.low.y,
                            (corner & 4) != 0 ? piece.bounds.high.z : piece.bounds.low.z}));
    }
  }

  /// Makes the placings of one piece consecutive instances.
  void emit() {
    const auto key = [](const Placing& p) { return std::tuple(p.role, p.piece->first_index, p.mirrored); };
    std::stable_sort(placings_.begin(), placings_.end(),
                     [&](const Placing& a, const Placing& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < placings_.size(); ++i) {
      const Placing& p = placings_[i];
      if (i == 0 || key(p) != key(placings_[i - 1]))
        scene_.draws.push_back({p.piece->first_index, p.piece->index_count, p.piece->vertex_offset,
                                static_cast<uint32_t>(scene_.instances.size()), 0, p.role, p.piece->double_sided,
                                p.mirrored});
      ++scene_.draws.back().instance_count;
      scene_.instances.push_back(p.instance);
    }
  }

  const GeometryEntry& entry_;
  Scene& scene_;
  tinygltf::Model model_;
  AccessorReader reader_;
  std::vector<bool> visited_;
  GltfMeshes meshes_;
  std::vector<Placing> placings_;
};

}  // namespace

void addGltf(const GeometryEntry& entry, Scene& scene) {
  GltfReader(entry, scene).read();
}

}  // namespace welkin::probes
