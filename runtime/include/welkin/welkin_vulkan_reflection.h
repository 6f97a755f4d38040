/* SPDX-License-Identifier: Apache-2.0
 *
 * The sky as rough surfaces reflect it, on Vulkan 1.3: a cubemap whose mips are the dome filtered with the lobes of
 * falling gloss, made on the device from the sky's formulas, and the descriptor set through which
 * shaders/welkin/reflected_sky.glsl reads it. C ABI; rules of threads, memory and command buffers as in
 * welkin_vulkan.h.
 *
 *     welkin_vulkan_update(sky, frame, &sample);
 *     welkin_vulkan_reflection_record(object, commands, sky, frame, 2, &left);  outside a render pass
 *     bind welkin_vulkan_reflection_descriptor_set(object) in the game's passes
 */
#ifndef WELKIN_WELKIN_VULKAN_REFLECTION_H
#define WELKIN_WELKIN_VULKAN_REFLECTION_H

#include <welkin/welkin_vulkan.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WELKIN_REFLECTION_LEAST_SIZE 16
#define WELKIN_REFLECTION_MOST_SIZE 512

/* The cubemap, pipeline and descriptor sets of one sky's reflection. */
typedef struct WelkinVulkanReflection WelkinVulkanReflection;

/* Creates the cubemap, of RGBA16F. `size` is the edge of its first mip in texels, a power of two from
 * WELKIN_REFLECTION_LEAST_SIZE to WELKIN_REFLECTION_MOST_SIZE; 128 suits most games. The last mip has 4 texels along an
 * edge. Mip k of n is for the gloss 1 - k/(n - 1). `info` is that of the sky; formats of attachments, the caller's
 * images and frames_in_flight do not matter here. `sky` need not outlive the call. One allocation. On an error *out is
 * null. WELKIN_ERROR_ARGUMENT, WELKIN_ERROR_MEMORY or WELKIN_ERROR_DEVICE. */
WELKIN_API WelkinResult welkin_vulkan_reflection_create(const WelkinVulkanCreateInfo* info, const WelkinVulkanSky* sky,
                                                        uint32_t size, WelkinVulkanReflection** out,
                                                        WelkinMessage* message);

/* Destroys the object. No command buffer that uses it may still be running. Null is allowed. */
WELKIN_API void welkin_vulkan_reflection_destroy(WelkinVulkanReflection* object);

/* Filters at most `budget` pieces of the dome that welkin_vulkan_update wrote for frame index `frame`; a piece is one
 * face of one mip, and none takes more than a tenth of the time of all. The first call filters all of them, whatever
 * the budget. Where a dome differs from that of the last call, all pieces count as old and are filtered in turn; a dome
 * that stays records nothing once all pieces show it. So at a budget of b no piece is older than pieces/b calls, and
 * UINT32_MAX shows the dome of this instant. *left, which may be null, is the number of pieces that are old after the
 * call. `sky` is any sky on this device whose upload was recorded before. All earlier reads of the cubemap on this
 * queue end before the passes, and fragment and compute shaders after them see the new texels. Leaves its pipeline,
 * sets 0 and 1 and push constants bound for compute. Radiance above 65504 is stored as 65504. */
WELKIN_API WelkinResult welkin_vulkan_reflection_record(WelkinVulkanReflection* object, VkCommandBuffer commands,
                                                        const WelkinVulkanSky* sky, uint32_t frame, uint32_t budget,
                                                        uint32_t* left);

/* Number of pieces: six for each mip. 0 for a null object. */
WELKIN_API uint32_t welkin_vulkan_reflection_pieces(const WelkinVulkanReflection* object);

/* Layout of the descriptor set: binding 0 the cubemap; fragment and compute shaders. VK_NULL_HANDLE for a null object.
 */
WELKIN_API VkDescriptorSetLayout welkin_vulkan_reflection_descriptor_set_layout(const WelkinVulkanReflection* object);

/* The descriptor set, the same for all frames. VK_NULL_HANDLE for a null object. */
WELKIN_API VkDescriptorSet welkin_vulkan_reflection_descriptor_set(const WelkinVulkanReflection* object);

/* Bytes of device memory: images; uniforms and staging are 0. */
WELKIN_API WelkinResult welkin_vulkan_reflection_memory(const WelkinVulkanReflection* object,
                                                        WelkinVulkanMemory* memory);

#ifdef __cplusplus
}
#endif

#endif
