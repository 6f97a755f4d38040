// SPDX-License-Identifier: Apache-2.0
// Records the passes that relight and fill, and what they read.
#include "vulkan/volume_relight.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "passes/volume_relight.h"
#include "vulkan/barriers.h"

namespace welkin::vulkan {
namespace {

using passes::SlotLight;
using probes::kColours;

using probes::BlockLayout;
static_assert(BlockLayout::kVisibility == WELKIN_BLOCK_VISIBILITY && BlockLayout::kSky == WELKIN_BLOCK_SKY &&
              BlockLayout::kSide == WELKIN_BLOCK_SIDE && BlockLayout::kSun == WELKIN_BLOCK_SUN);

constexpr VkDeviceSize kSlotBytes = 4 * WELKIN_SLOT_WORDS, kFixedBytes = 4 * WELKIN_SLOT_FIXED;

/// The sectors of a level that light a volume's texels or bricks, each at its slot.
void findSectors(const WelkinVolume& volume, RelightSlot* wanted, uint32_t slots) {
  std::fill_n(wanted, slots, RelightSlot{});
  const auto sectorOf = [](int64_t cell) {
    return static_cast<int64_t>(std::floor(static_cast<double>(cell) / format::kCellsAcross));
  };
  const auto isNear = [&](int64_t sector, size_t axis) {
    const int64_t first = volume.first[axis];
    return sector >= sectorOf(first) - 1 && sector <= sectorOf(first + volume.count[axis] - 1) + 1;
  };
  const WelkinLevel& level = *volume.level;
  for (uint32_t i = 0; i < level.count; ++i) {
    const WelkinSector* s = level.resident.get()[i];
    if (s->probes == 0 || !isNear(s->x, 0) || !isNear(s->z, 2)) continue;
    wanted[probes::slotOf(volume, s->x, s->z)] = {s, s->arrival, s->fixed_changes};
  }
}

/// Copies a sector to the frame's staging memory and records its way to its slot.
void recordSlot(const Device& device, const VolumeRelight& o, VkCommandBuffer commands, const WelkinSector& sector,
                uint32_t slot, VkDeviceSize offset) {
  const VkDeviceSize blocks = (sector.probes + probes::kBlock - 1) / probes::kBlock;
  VkBufferCopy copy[2] = {{offset, slot * kSlotBytes, blocks * BlockLayout{sector.modes}.bytes()}, {}};
  std::memcpy(o.staging.mapped + offset, sector.blocks.get(), copy[0].size);
  uint32_t copies = 1;
  if (sector.fixed.get() != nullptr) {
    copy[copies++] = {offset + kFixedBytes, slot * kSlotBytes + kFixedBytes, sizeof(float) * kColours * sector.probes};
    std::memcpy(o.staging.mapped + copy[1].srcOffset, sector.fixed.get(), copy[1].size);
  }
  device.fn.CmdCopyBuffer(commands, o.staging.buffer, o.probes.buffer, copies, copy);
}

SlotLight lightOf(const WelkinSector& sector, const probes::LevelLight& light) {
  const probes::SectorLight now = probes::sectorLightOf(light, *sector.file);
  SlotLight out{};
  static_assert(sizeof now.open == sizeof out.open && sizeof now.sky == sizeof out.sky &&
                sizeof now.mode == sizeof out.mode);
  std::memcpy(out.open, now.open, sizeof out.open);
  std::memcpy(out.sky, now.sky, sizeof out.sky);
  std::memcpy(out.mode, now.mode, sizeof out.mode);
  out.local = now.local;
  out.lights = now.lights;
  out.modes = static_cast<uint32_t>(sector.modes);
  out.probes = sector.probes;
  out.is_fixed = sector.fixed.get() == nullptr ? 0 : 1;
  return out;
}

/// Writes the light of the instant for the frame.
void writeLight(const VolumeRelight& o, const WelkinVolume& volume, unsigned char* to) {
  passes::VolumeLight all{};
  std::memcpy(all.open, volume.open_light.data(), sizeof all.open);
  all.inverse_scale = 1.0F / volume.scale;
  all.slots = o.slots;
  std::memcpy(to, &all, sizeof all);
  for (uint32_t s = 0; s < o.slots; ++s) {
    const SlotLight light = o.slot[s].sector == nullptr ? SlotLight{} : lightOf(*o.slot[s].sector, volume.level->light);
    std::memcpy(to + sizeof all + s * sizeof light, &light, sizeof light);
  }
}

/// Copies the sectors that came or changed. Returns whether there were any.
bool recordSlots(const Device& device, VolumeRelight& o, const WelkinVolume& volume, VkCommandBuffer commands,
                 uint32_t frame) {
  RelightSlot* wanted = o.slot + o.slots;
  findSectors(volume, wanted, o.slots);
  const VkDeviceSize first = frame * o.frame_bytes + o.light_bytes;
  bool changed = false;
  for (uint32_t s = 0; s < o.slots; ++s) {
    const bool is_same = wanted[s].sector == o.slot[s].sector && wanted[s].arrival == o.slot[s].arrival &&
                         wanted[s].fixed_changes == o.slot[s].fixed_changes;
    o.slot[s] = wanted[s];
    if (is_same) continue;
    if (!changed)
      recordBarrier(device, commands, o.probes.buffer, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE,
                    VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    changed = true;
    if (o.slot[s].sector == nullptr) continue;
    recordSlot(device, o, commands, *o.slot[s].sector, s, first + s * kSlotBytes);
  }
  if (changed)
    recordBarrier(device, commands, o.probes.buffer, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
  return changed;
}

void recordPasses(const Device& device, const VolumeRelight& o, const RelightImages& images, VkCommandBuffer commands,
                  VkDescriptorSet set) {
  const auto& fn = device.fn;
  constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  fn.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, o.pipeline_layout, 0, 1, &set, 0, nullptr);
  recordBarrier(device, commands, o.relit.buffer, kCompute, VK_ACCESS_2_NONE, kCompute,
                VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
  fn.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, o.pipelines[0]);
  fn.CmdDispatch(commands, o.slots * WELKIN_SLOT_PROBES * 4 / 64, 1, 1);
  recordBarrier(device, commands, o.relit.buffer, kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, kCompute,
                VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
  VkImageMemoryBarrier2 before[3], after[3];
  for (int c = 0; c < 3; ++c) {
    before[c] = imageBarrier(images.texels[c], o.is_filled ? kShaders : VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                             o.is_filled ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_UNDEFINED,
                             kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL);
    after[c] = imageBarrier(images.texels[c], kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL,
                            kShaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  }
  recordBarriers(device, commands, before, 3);
  fn.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, o.pipelines[1]);
  const VkExtent3D& e = images.extent;
  fn.CmdDispatch(commands, (e.width + 7) / 8, (e.height + 3) / 4, (e.depth + 1) / 2);
  recordBarriers(device, commands, after, 3);
}

}  // namespace

void recordRelight(const Device& device, VolumeRelight& o, const RelightImages& images, const WelkinVolume& volume,
                   VkCommandBuffer commands, uint32_t frame, bool words_changed) {
  const bool slots_changed = recordSlots(device, o, volume, commands, frame);
  if (o.is_filled && !words_changed && !slots_changed && o.instant == volume.level->instant &&
      o.scale == volume.scale && o.open == volume.open_light)
    return;
  writeLight(o, volume, o.staging.mapped + frame * o.frame_bytes);
  recordPasses(device, o, images, commands, o.sets.sets[frame]);
  o.instant = volume.level->instant;
  o.scale = volume.scale;
  o.open = volume.open_light;
  o.is_filled = true;
}

}  // namespace welkin::vulkan
