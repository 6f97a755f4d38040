// SPDX-License-Identifier: Apache-2.0
// Uploads a scene and records its draws.
#include "render/level_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "render/shaders/level_glass_push.h"

namespace welkin::render {
namespace {

/// Creates a buffer that is never empty, since a level may hold nothing but the sea.
template <typename T>
VkDeviceSize bytesOf(const std::vector<T>& list) {
  return std::max<std::size_t>(list.size(), 1) * sizeof(T);
}

template <typename T>
void fill(const Buffer& buffer, const std::vector<T>& list) {
  if (!list.empty()) std::memcpy(buffer.as<T>(), list.data(), list.size() * sizeof(T));
}

/// An instance as level_instances.glsl reads it.
struct PlacedInstance {
  level::Instance placed;
  float emission[4];
};

std::vector<PlacedInstance> instancesOf(const level::Scene& scene, double luminance_unit, bool emits) {
  std::vector<PlacedInstance> instances;
  for (const level::Instance& instance : scene.instances) instances.push_back({instance, {}});
  for (const level::Draw& draw : scene.draws) {
    const geometry::Material& surface = scene.materials[draw.material].surface;
    const f64::Number3 emission = surface.emission * ((!emits            ? 0.0
                                                       : surface.blended ? surface.alpha
                                                                         : 1.0) /
                                                      luminance_unit);
    for (uint32_t i = 0; i < draw.instance_count; ++i)
      for (int c = 0; c < 3; ++c) instances[draw.first_instance + i].emission[c] = static_cast<float>(emission[c]);
  }
  return instances;
}

}  // namespace

LevelMesh::LevelMesh(const VulkanDevice& device, const level::Scene& scene, double luminance_unit, bool emits)
    : scene_(scene),
      vertices_(device, bytesOf(scene.vertices), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT),
      indices_(device, bytesOf(scene.indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT),
      instances_(device, std::max<std::size_t>(scene.instances.size(), 1) * sizeof(PlacedInstance),
                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) {
  fill(vertices_, scene.vertices);
  fill(indices_, scene.indices);
  fill(instances_, instancesOf(scene, luminance_unit, emits));
}

std::span<const VkVertexInputAttributeDescription> LevelMesh::attributes() {
  static constexpr VkVertexInputAttributeDescription kAttributes[3] = {
      {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(level::Vertex, position)},
      {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(level::Vertex, normal)},
      {2, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(level::Vertex, colour)}};
  return kAttributes;
}

bool LevelMesh::isGlass(const level::Draw& draw) const {
  return draw.role != geometry::Role::water && scene_.materials[draw.material].surface.letsLightThrough();
}

bool LevelMesh::hasGlass() const {
  return std::any_of(scene_.draws.begin(), scene_.draws.end(), [&](const level::Draw& draw) { return isGlass(draw); });
}

void LevelMesh::bind(VkCommandBuffer commands) const {
  const VkDeviceSize offset = 0;
  const VkBuffer vertices = vertices_.handle();
  vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
  vkCmdBindIndexBuffer(commands, indices_.handle(), 0, VK_INDEX_TYPE_UINT32);
}

void LevelMesh::recordGlass(VkCommandBuffer commands, VkPipelineLayout layout) const {
  bind(commands);
  for (const level::Draw& draw : scene_.draws) {
    if (!isGlass(draw)) continue;
    const geometry::Material& surface = scene_.materials[draw.material].surface;
    const shaders::GlassPush push{surface.blended ? static_cast<float>(surface.alpha) : 1.0F,
                                  static_cast<float>(surface.transmission)};
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(push), &push);
    vkCmdDrawIndexed(commands, draw.index_count, draw.instance_count, draw.first_index, draw.vertex_offset,
                     draw.first_instance);
  }
}

void LevelMesh::record(VkCommandBuffer commands, bool cull, bool mirrored) const {
  bind(commands);
  for (const level::Draw& draw : scene_.draws) {
    if (draw.role == geometry::Role::water || isGlass(draw)) continue;
    if (cull) {
      // Device coordinates are y-down, so glTF's counter-clockwise front stays counter-clockwise on the screen.
      vkCmdSetCullMode(commands, draw.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
      vkCmdSetFrontFace(commands,
                        draw.mirrored != mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    }
    vkCmdDrawIndexed(commands, draw.index_count, draw.instance_count, draw.first_index, draw.vertex_offset,
                     draw.first_instance);
  }
}

}  // namespace welkin::render
