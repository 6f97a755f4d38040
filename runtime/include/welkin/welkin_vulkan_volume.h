/* SPDX-License-Identifier: Apache-2.0
 *
 * The volume of probes on Vulkan 1.3: three 3D textures, the buffer of cells along walls, the far map, and the
 * descriptor set through which shaders/welkin/volume.glsl and far.glsl read them. C ABI; rules of threads, memory and
 * command buffers as in welkin_vulkan.h.
 *
 *     welkin_volume_update(volume, level, &sample, camera, budget, &update);
 *     welkin_vulkan_volume_record(object, commands, frame, volume, &update);  outside a render pass
 *     bind welkin_vulkan_volume_descriptor_set(object, frame) in the game's ambient pass
 */
#ifndef WELKIN_WELKIN_VULKAN_VOLUME_H
#define WELKIN_WELKIN_VULKAN_VOLUME_H

#include <welkin/volume.h>
#include <welkin/welkin_vulkan.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The textures, buffers and descriptor sets of one volume. */
typedef struct WelkinVulkanVolume WelkinVulkanVolume;

/* Creates the textures for a volume. `info` is that of the sky; the formats of the dome's attachments and the caller's
 * images do not matter here. Three allocations: the textures, the buffer of cells along walls, and staging of
 * frames_in_flight times the volume's size. WELKIN_VOLUME_DEVICE needs three more: the probes of the sectors about the
 * volume, their light, and staging of frames_in_flight times the probes.
 * On an error *out is null. WELKIN_ERROR_ARGUMENT, WELKIN_ERROR_MEMORY or WELKIN_ERROR_DEVICE. */
WELKIN_API WelkinResult welkin_vulkan_volume_create(const WelkinVulkanCreateInfo* info, const WelkinVolume* volume,
                                                    WelkinVulkanVolume** out, WelkinMessage* message);

/* Destroys the object. No command buffer that uses it may still be running. Null is allowed. */
WELKIN_API void welkin_vulkan_volume_destroy(WelkinVulkanVolume* object);

/* Records the copy of the boxes, words and rectangles that an update changed, and writes the constants of frame index
 * `frame`. For WELKIN_VOLUME_DEVICE it also copies sectors that are new, and records two compute passes: one relights
 * all probes about the volume, the other fills all texels. It records neither where nothing changed. No function of the
 * level may run between welkin_volume_update and this call. Every update of the volume is recorded once, in order; the
 * first must fill the whole volume, as an update of a new volume does. No command buffer of this frame index may be
 * running. All earlier reads of the textures on this queue end before the copy, and fragment and compute shaders after
 * it see the new texels. */
WELKIN_API WelkinResult welkin_vulkan_volume_record(WelkinVulkanVolume* object, VkCommandBuffer commands,
                                                    uint32_t frame, const WelkinVolume* volume,
                                                    const WelkinVolumeUpdate* update);

/* Layout of the descriptor set: binding 0 the constants, binding 1 the three textures, binding 2 the buffer of cells
 * along walls, binding 3 the far map; fragment and compute shaders.
 * VK_NULL_HANDLE for a null object. */
WELKIN_API VkDescriptorSetLayout welkin_vulkan_volume_descriptor_set_layout(const WelkinVulkanVolume* object);

/* Descriptor set of a frame index. VK_NULL_HANDLE for a null object and for a frame that is not below frames_in_flight.
 */
WELKIN_API VkDescriptorSet welkin_vulkan_volume_descriptor_set(const WelkinVulkanVolume* object, uint32_t frame);

/* Bytes of device memory: images (with the buffer of cells along walls), uniforms (0: they lie in staging) and staging.
 */
WELKIN_API WelkinResult welkin_vulkan_volume_memory(const WelkinVulkanVolume* object, WelkinVulkanMemory* memory);

#ifdef __cplusplus
}
#endif

#endif
