// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace welkin::gltf {
namespace {

using f64::Number3;

Number3 intensityOf(const tinygltf::Light& light, const std::string& what, const AccessorReader& reader) {
  if (!light.color.empty() && light.color.size() != 3) reader.refuse(what, "the light's color must have 3 numbers");
  constexpr double kLargest = 1e12;
  Number3 intensity(light.intensity);
  for (int i = 0; i < 3; ++i) {
    if (!light.color.empty()) intensity[i] *= light.color[static_cast<std::size_t>(i)];
    if (!(intensity[i] >= 0.0 && intensity[i] <= kLargest))
      reader.refuse(what,
                    fmt::format("the light's color times intensity is {}, must be 0 to {}", intensity[i], kLargest));
  }
  return intensity;
}

double inverseRange4Of(const tinygltf::Light& light, const std::string& what, const AccessorReader& reader) {
  constexpr double kShortest_m = 1e-6;
  if (light.range == 0.0) return 0.0;  // tinygltf's value of a light without a range
  if (!(light.range >= kShortest_m))
    reader.refuse(what, fmt::format("the light's range is {}, must be {} or more", light.range, kShortest_m));
  const double squared = light.range * light.range;
  return 1.0 / (squared * squared);
}

void readCone(const tinygltf::SpotLight& spot, const std::string& what, const AccessorReader& reader,
              geometry::StaticLight& light) {
  constexpr double kRounding = 1e-6;  // exporters write floats
  if (!(spot.innerConeAngle >= 0.0 && spot.innerConeAngle < spot.outerConeAngle &&
        spot.outerConeAngle <= f64::kHalfPi + kRounding))
    reader.refuse(what, fmt::format("the light's innerConeAngle is {} and its outerConeAngle {}: must be 0 or more, "
                                    "the second larger and at most pi / 2",
                                    spot.innerConeAngle, spot.outerConeAngle));
  geometry::setCone(light, spot.innerConeAngle, std::min(spot.outerConeAngle, f64::kHalfPi));
}

}  // namespace

std::optional<geometry::StaticLight> readLight(const tinygltf::Light& light, const geometry::Affine& transform,
                                               const std::string& what, const AccessorReader& reader) {
  if (light.type != "point" && light.type != "spot" && light.type != "directional")
    reader.refuse(
        what, fmt::format("the light's type = \"{}\": must be directional, point or spot", light.type.substr(0, 20)));
  geometry::StaticLight result;
  result.intensity = intensityOf(light, what, reader);
  result.directional = light.type == "directional";
  if (!result.directional) {
    constexpr double kFarthest_m = 1e6;
    result.position = transform.translation;
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(result.position[i]) <= kFarthest_m))
        reader.refuse(what, fmt::format("its light is at {} m: at most {} from the origin is allowed",
                                        result.position[i], kFarthest_m));
    result.inverse_range4 = inverseRange4Of(light, what, reader);
  }
  if (light.type == "spot") readCone(light.spot, what, reader, result);
  if (light.type == "point") return result;
  const double length = std::sqrt(dot(transform.z, transform.z));
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  result.axis = -transform.z / length;
  return result;
}

}  // namespace welkin::gltf
