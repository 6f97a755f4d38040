// SPDX-License-Identifier: Apache-2.0
// Uploads a scene and records its draws.
#include "render/level_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>

#include "materials.h"
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
  float emission[3];
  std::int32_t contact;
  float gloss[4];  ///< the first alone
};

/// Of an instance without contact factors.
constexpr std::int32_t kWithout = std::numeric_limits<std::int32_t>::min();

std::vector<PlacedInstance> instancesOf(const level::Scene& scene, double luminance_unit, bool emits) {
  std::vector<PlacedInstance> instances;
  for (const level::Instance& instance : scene.instances) instances.push_back({instance, {}, kWithout, {}});
  for (const level::Draw& draw : scene.draws) {
    const level::SceneMaterial& material = scene.materials[draw.material];
    const geometry::Material& surface = material.surface;
    const f64::Number3 emission = surface.emission * ((!emits            ? 0.0
                                                       : surface.blended ? surface.alpha
                                                                         : 1.0) /
                                                      luminance_unit);
    const double gloss = f64::glossOfPower(f64::powerOfRoughness(material.roughness));
    for (uint32_t i = draw.first_instance; i < draw.first_instance + draw.instance_count; ++i) {
      instances[i].placed.albedo[3] = static_cast<float>(material.metallic);
      instances[i].gloss[0] = static_cast<float>(gloss);
      for (int c = 0; c < 3; ++c) instances[i].emission[c] = static_cast<float>(emission[c]);
      if (!scene.contact.empty() && scene.first_contact[i] != level::kNoContact)
        instances[i].contact = static_cast<std::int32_t>(scene.first_contact[i]) - draw.vertex_offset;
    }
  }
  return instances;
}

}  // namespace

LevelMesh::LevelMesh(const VulkanDevice& device, const level::Scene& scene, double luminance_unit, bool emits)
    : device_(device),
      scene_(scene),
      spheres_(instanceSpheres(scene)),
      vertices_(device, bytesOf(scene.vertices), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT),
      indices_(std::make_unique<Buffer>(device, bytesOf(scene.indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT)),
      instances_(device, std::max<std::size_t>(scene.instances.size(), 1) * sizeof(PlacedInstance),
                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT),
      contact_(device, (scene.contact.size() / 4 + 1) * 4, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) {
  fill(contact_, scene.contact);
  fill(vertices_, scene.vertices);
  fill(*indices_, scene.indices);
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
  vkCmdBindIndexBuffer(commands, indices_->handle(), 0, VK_INDEX_TYPE_UINT32);
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

void LevelMesh::simplify() {
  if (!coarse_.empty()) return;
  CoarseMesh mesh = coarseMesh(scene_);
  std::vector<uint32_t> all = scene_.indices;
  const auto own = static_cast<uint32_t>(all.size());
  all.insert(all.end(), mesh.indices.begin(), mesh.indices.end());
  for (auto& levels : mesh.draw)
    for (CoarseDraw& draw : levels) draw.first_index += own;
  indices_ = std::make_unique<Buffer>(device_, bytesOf(all), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  fill(*indices_, all);
  coarse_ = std::move(mesh.draw);
}

std::optional<std::size_t> LevelMesh::levelOf(std::size_t draw, uint32_t instance, const ViewCone* cone,
                                              double coarse) const {
  if (cone == nullptr) return 0;
  const Sphere& sphere = spheres_[instance];
  if (!cone->sees(sphere)) return std::nullopt;
  if (coarse <= 0.0) return 0;
  const double metre = cone->heightOfMetre(sphere);
  if (sphere.radius * metre < coarse) return std::nullopt;
  for (std::size_t i = kCoarseLevels; i > 0; --i)
    if (coarse_[draw][i - 1].error_m * sphere.scale * metre < coarse) return i;
  return 0;
}

void LevelMesh::record(VkCommandBuffer commands, const float (*view)[16], bool mirrored, double coarse) const {
  bind(commands);
  const std::optional<ViewCone> cone = view == nullptr ? std::nullopt : std::optional<ViewCone>(*view);
  for (std::size_t d = 0; d < scene_.draws.size(); ++d) {
    const level::Draw& draw = scene_.draws[d];
    if (draw.role == geometry::Role::water || isGlass(draw)) continue;
    if (cone) {
      // Device coordinates are y-down, so glTF's counter-clockwise front stays counter-clockwise on the screen.
      vkCmdSetCullMode(commands, draw.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
      vkCmdSetFrontFace(commands,
                        draw.mirrored != mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    }
    const uint32_t end = draw.first_instance + draw.instance_count;
    const auto level = [&](uint32_t i) { return levelOf(d, i, cone ? &*cone : nullptr, coarse); };
    for (uint32_t from = draw.first_instance; from < end;) {
      const std::optional<std::size_t> now = level(from);
      uint32_t to = from + 1;
      while (to < end && level(to) == now) ++to;
      if (now == std::size_t{0})
        vkCmdDrawIndexed(commands, draw.index_count, to - from, draw.first_index, draw.vertex_offset, from);
      else if (now)
        vkCmdDrawIndexed(commands, coarse_[d][*now - 1].index_count, to - from, coarse_[d][*now - 1].first_index,
                         draw.vertex_offset, from);
      from = to;
    }
  }
}

}  // namespace welkin::render
