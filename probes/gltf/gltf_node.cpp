// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "probes/gltf/gltf_value.h"
#include "probes/level/scene_builder.h"

namespace welkin::gltf {

using f64::Number3;

std::string nodeName(int index, const tinygltf::Node& node) {
  return fmt::format("node {} \"{}\"", index, node.name.substr(0, 60));
}

geometry::Affine nodeTransform(int index, const tinygltf::Node& node, const AccessorReader& reader) {
  const auto check = [&](const std::vector<double>& numbers, std::size_t size, const char* what) {
    if (!numbers.empty() && numbers.size() != size)
      reader.refuse(nodeName(index, node), fmt::format("{} has {} numbers, must have {}", what, numbers.size(), size));
    for (const double number : numbers)
      if (!(std::abs(number) <= 1e9)) reader.refuse(nodeName(index, node), fmt::format("{} holds {}", what, number));
  };
  check(node.matrix, 16, "matrix");
  check(node.translation, 3, "translation");
  check(node.rotation, 4, "rotation");
  check(node.scale, 3, "scale");
  const auto& m = node.matrix;
  constexpr double kRounding = 1e-6;  // of an exporter
  if (!m.empty() && !(std::abs(m[3]) <= kRounding && std::abs(m[7]) <= kRounding && std::abs(m[11]) <= kRounding &&
                      std::abs(m[15] - 1.0) <= kRounding))
    reader.refuse(nodeName(index, node),
                  fmt::format("matrix is projective: its last row is {}, {}, {}, {}, must be 0, 0, 0, 1", m[3], m[7],
                              m[11], m[15]));
  if (!m.empty()) return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
  const auto vector = [](const std::vector<double>& v, double otherwise) {
    return v.empty() ? Number3(otherwise) : Number3(v[0], v[1], v[2]);
  };
  double rotation[4] = {0.0, 0.0, 0.0, 1.0};
  if (!node.rotation.empty()) {
    double length = 0.0;
    for (const double q : node.rotation) length += q * q;
    if (!(length > 0.0)) reader.refuse(nodeName(index, node), "rotation is zero");
    for (std::size_t i = 0; i < 4; ++i) rotation[i] = node.rotation[i] / std::sqrt(length);
  }
  return geometry::fromTrs(vector(node.translation, 0.0), rotation, vector(node.scale, 1.0));
}

geometry::Role nodeRole(int index, const tinygltf::Node& node, const level::GeometryEntry& entry,
                        geometry::Role inherited, const AccessorReader& reader) {
  if (node.extras.Has("role")) {
    const tinygltf::Value& value = node.extras.Get("role");
    const std::string name = value.IsString() ? value.Get<std::string>() : "";
    const auto role = level::roleOf(name);
    if (!role)
      reader.refuse(nodeName(index, node),
                    fmt::format("extras.role = \"{}\": must be static, vegetation, water or ignore", name));
    return *role;
  }
  return level::matchesAny(entry.vegetation_nodes, node.name) ? geometry::Role::vegetation : inherited;
}

bool isVisible(const tinygltf::Node& node) {
  const tinygltf::Value extension = extensionOf(node.extensions, "KHR_node_visibility");
  return !extension.Has("visible") || extension.Get("visible").Get<bool>();
}

const tinygltf::Light* nodeLight(int index, const tinygltf::Node& node, const tinygltf::Model& model,
                                 const AccessorReader& reader) {
  const int light = indexIn(extensionOf(node.extensions, "KHR_lights_punctual"), "light", model.lights.size(), reader,
                            nodeName(index, node));
  return light < 0 ? nullptr : &model.lights[static_cast<std::size_t>(light)];
}

}  // namespace welkin::gltf
