// SPDX-License-Identifier: Apache-2.0
// A probe in the level picture: the instance data of its sphere.
#pragma once

#include <array>
#include <cstddef>

#include "render/vulkan_device.h"

namespace welkin::render {

struct ProbeSphere {
  float position[3];       ///< metres
  float irradiance[4][3];  ///< by direction of the transfer basis, pi included, scene units

  static constexpr uint32_t kVertices = 36;  ///< vertices of the cube around it, made by level_probes.vert
  static const std::array<VkVertexInputAttributeDescription, 5> kAttributes;
};

inline constexpr std::array<VkVertexInputAttributeDescription, 5> ProbeSphere::kAttributes = [] {
  std::array<VkVertexInputAttributeDescription, 5> attributes{};
  for (uint32_t i = 0; i < attributes.size(); ++i)
    attributes[i] = {i, 0, VK_FORMAT_R32G32B32_SFLOAT, i * uint32_t{sizeof(ProbeSphere::position)}};
  return attributes;
}();
static_assert(offsetof(ProbeSphere, irradiance) == sizeof(ProbeSphere::position));
static_assert(sizeof(ProbeSphere::irradiance) == 4 * sizeof(ProbeSphere::position));

}  // namespace welkin::render
