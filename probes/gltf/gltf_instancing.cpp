// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_instancing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "probes/gltf/gltf_node.h"
#include "probes/gltf/gltf_value.h"

namespace welkin::gltf {
namespace {

using f64::Number3;

/// Rows of one attribute; no components if it is missing.
level::FloatRows rowsOf(const tinygltf::Value& attributes, const char* name, int components, Integers integers,
                        const AccessorReader& reader, const std::string& what) {
  if (!attributes.Has(name)) return {};
  return reader.floats(attributes.Get(name).GetNumberAsInt(), fmt::format("{} {}", what, name), components, components,
                       integers);
}

Number3 vectorAt(const level::FloatRows& rows, std::size_t i, double otherwise) {
  if (rows.components == 0) return Number3(otherwise);
  return {double{rows.values[3 * i]}, double{rows.values[3 * i + 1]}, double{rows.values[3 * i + 2]}};
}

}  // namespace

std::vector<geometry::Affine> instancesOf(int index, const tinygltf::Node& node, const AccessorReader& reader) {
  constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";
  if (node.extensions.count(kInstancing) == 0) return {geometry::Affine{}};
  const tinygltf::Value extension = extensionOf(node.extensions, kInstancing);
  const tinygltf::Value& attributes = extension.Get("attributes");
  const std::string what = fmt::format("{} {}", nodeName(index, node), kInstancing);
  const level::FloatRows moves = rowsOf(attributes, "TRANSLATION", 3, Integers::none, reader, what);
  const level::FloatRows turns = rowsOf(attributes, "ROTATION", 4, Integers::any_fractions, reader, what);
  const level::FloatRows scales = rowsOf(attributes, "SCALE", 3, Integers::none, reader, what);
  const std::size_t count = std::max({moves.count, turns.count, scales.count});
  if (count == 0) reader.refuse(what, "has none of TRANSLATION, ROTATION and SCALE");
  for (const level::FloatRows* rows : {&moves, &turns, &scales}) {
    if (rows->components != 0 && rows->count != count)
      reader.refuse(
          what, fmt::format("has {} translations, {} rotations and {} scales", moves.count, turns.count, scales.count));
    for (const float value : rows->values)
      if (!(std::abs(value) <= 1e9F)) reader.refuse(what, fmt::format("holds {}", value));
  }
  std::vector<geometry::Affine> instances;
  instances.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    double rotation[4] = {0.0, 0.0, 0.0, 1.0};
    if (turns.components != 0) {
      double length = 0.0;
      for (std::size_t c = 0; c < 4; ++c) length += double{turns.values[4 * i + c]} * double{turns.values[4 * i + c]};
      if (!(length > 0.0)) reader.refuse(what, fmt::format("rotation {} is zero", i));
      for (std::size_t c = 0; c < 4; ++c) rotation[c] = double{turns.values[4 * i + c]} / std::sqrt(length);
    }
    instances.push_back(geometry::fromTrs(vectorAt(moves, i, 0.0), rotation, vectorAt(scales, i, 1.0)));
  }
  return instances;
}

}  // namespace welkin::gltf
