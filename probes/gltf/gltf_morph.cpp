// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace welkin::gltf {
namespace {

/// Adds `weight` times the target's rows to the first components of the base's.
void add(const level::FloatRows& target, double weight, level::FloatRows& rows) {
  const auto from = static_cast<std::size_t>(target.components);
  const auto to = static_cast<std::size_t>(rows.components);
  for (std::size_t i = 0; i < rows.count; ++i)
    for (std::size_t c = 0; c < std::min(from, to); ++c) {
      float& value = rows.values[i * to + c];
      value = static_cast<float>(double{value} + weight * double{target.values[i * from + c]});
    }
}

void makeUnit(level::FloatRows& normals) {
  for (std::size_t i = 0; i + 2 < normals.values.size(); i += 3) {
    float* n = normals.values.data() + i;
    const double length =
        std::sqrt(double{n[0]} * double{n[0]} + double{n[1]} * double{n[1]} + double{n[2]} * double{n[2]});
    if (!(length > 0.0)) continue;
    for (int c = 0; c < 3; ++c) n[c] = static_cast<float>(double{n[c]} / length);
  }
}

}  // namespace

void addMorphTargets(const tinygltf::Primitive& primitive, const std::vector<double>& weights, int uv_set,
                     const AccessorReader& reader, const std::string& what, level::Attributes& attributes) {
  if (weights.size() > primitive.targets.size() && !primitive.targets.empty())
    reader.refuse(what, fmt::format("{} weights for {} morph targets", weights.size(), primitive.targets.size()));
  constexpr double kLargest = 1e9;
  bool bent = false;
  for (std::size_t t = 0; t < std::min(weights.size(), primitive.targets.size()); ++t) {
    if (!(std::abs(weights[t]) <= kLargest)) reader.refuse(what, fmt::format("weight {} is {}", t, weights[t]));
    if (weights[t] == 0.0) continue;
    const auto put = [&](const std::string& name, int least, int most, Integers integers, level::FloatRows& rows) {
      const auto found = primitive.targets[t].find(name);
      if (found == primitive.targets[t].end() || rows.components == 0) return false;
      const std::string who = fmt::format("{} target {} {}", what, t, name);
      const level::FloatRows target = reader.floats(found->second, who, least, most, integers);
      if (target.count != rows.count)
        reader.refuse(who, fmt::format("has {} elements for {} vertices", target.count, rows.count));
      add(target, weights[t], rows);
      return true;
    };
    put("POSITION", 3, 3, Integers::quantized, attributes.positions);
    bent = put("NORMAL", 3, 3, Integers::quantized, attributes.normals) || bent;
    const bool tinted = put("COLOR_0", 3, 4, Integers::any_fractions, attributes.colours);
    if (tinted)
      for (float& value : attributes.colours.values) value = std::clamp(value, 0.0F, 1.0F);
    if (uv_set >= 0)
      put(fmt::format("TEXCOORD_{}", uv_set), 2, 2, reader.quantized() ? Integers::quantized : Integers::any_fractions,
          attributes.uv);
  }
  if (bent) makeUnit(attributes.normals);
}

}  // namespace welkin::gltf
