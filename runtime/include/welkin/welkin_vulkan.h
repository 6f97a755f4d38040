/* SPDX-License-Identifier: Apache-2.0
 *
 * Welkin on Vulkan 1.3: draws the sky dome, and makes the descriptor set through which the game's shaders read the
 * sky's ambient light. C ABI.
 *
 * The caller owns the instance, the device and every command buffer. The library creates images, buffers and pipelines
 * once, records into the caller's command buffers, and never submits, waits or locks. After creation it allocates
 * nothing, on the host or on the device. It links no Vulkan loader.
 *
 * The device needs Vulkan 1.3 with dynamicRendering and synchronization2 enabled; no extension, no other feature.
 *
 * At load time                                   Every frame, once the GPU is done with this frame index
 *   1. welkin_vulkan_create                        1. welkin_sky_sample
 *   2. welkin_vulkan_record_upload, submit         2. welkin_vulkan_update
 *   3. when that submission has finished:          3. bind welkin_vulkan_descriptor_set in the caller's own passes
 *      welkin_vulkan_free_staging                  4. welkin_vulkan_draw_dome inside dynamic rendering
 *
 * Shaders: welkin/sky_bindings.h, ambient.glsl, modes.glsl, dome.glsl and discs.glsl, in the folder shaders/welkin. If
 * the file has modes (WelkinSkyInfo::mode_count), light with modes.glsl, which computes welkin_sky_irradiance. The file
 * ambient.glsl computes welkin_sample_irradiance, for every file.
 *
 * Threads: there is no global state; different objects may be used at once. Calls on one object must not overlap.
 * Functions that take a const WelkinVulkanSky, such as welkin_vulkan_draw_dome, are the exception: any number of
 * threads may call them at once, with different command buffers.
 */
#ifndef WELKIN_WELKIN_VULKAN_H
#define WELKIN_WELKIN_VULKAN_H

#include <vulkan/vulkan_core.h>
#include <welkin/welkin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT 16

/* The images, buffers, pipelines and descriptor sets of one sky. */
typedef struct WelkinVulkanSky WelkinVulkanSky;

/* A piece of device memory from the caller's allocator. The library makes these structs; they can grow at their end. */
typedef struct WelkinVulkanAllocation {
  VkDeviceMemory memory;
  VkDeviceSize offset; /* bytes; a multiple of the required alignment */
  void* mapped;        /* host address of `offset`, valid until the free; only if host-visible was required */
  void* user;          /* not read by the library */
} WelkinVulkanAllocation;

/* Lets an allocator of the caller, such as VMA, own the device memory. welkin_vulkan_create makes at most three
 * allocations: the images, the uniforms and the staging buffer. Nothing is allocated later. */
typedef struct WelkinVulkanMemoryCallbacks {
  WELKIN_STRUCT_SIZE(WelkinVulkanMemoryCallbacks);
  uint32_t reserved; /* 0 */
  void* user;
  VkResult (*allocate)(void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags required,
                       VkMemoryPropertyFlags preferred, WelkinVulkanAllocation* allocation);
  void (*free)(void* user, const WelkinVulkanAllocation* allocation);
} WelkinVulkanMemoryCallbacks;

/* Zero-initialise it. Fields whose comments name a meaning of 0 or null are optional. */
typedef struct WelkinVulkanCreateInfo {
  WELKIN_STRUCT_SIZE(WelkinVulkanCreateInfo);
  uint32_t api_version; /* apiVersion of the caller's VkApplicationInfo, at least VK_API_VERSION_1_3 */
  PFN_vkGetInstanceProcAddr get_instance_proc_addr;
  VkInstance instance;
  VkPhysicalDevice physical_device;
  VkDevice device;
  const VkAllocationCallbacks* allocator;    /* for Vulkan's host memory; may be null; must outlive the object */
  VkPipelineCache pipeline_cache;            /* may be null */
  uint32_t frames_in_flight;                 /* number of frame indices, 1..WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT */
  VkFormat colour_format;                    /* colour attachment of the dome's pass; receives radiance, and alpha 1 */
  VkFormat depth_format;                     /* depth attachment of that pass; VK_FORMAT_UNDEFINED without one */
  VkFormat stencil_format;                   /* stencil attachment of that pass; VK_FORMAT_UNDEFINED without one */
  VkCompareOp depth_compare;                 /* depth test of the dome, which writes no depth; unused without depth */
  VkSampleCountFlagBits samples;             /* samples of those attachments; 0 counts as 1 */
  const WelkinVulkanMemoryCallbacks* memory; /* null: the library allocates. Copied: need not outlive the call */
  const VkImage* images;                     /* null: the library makes its images. Else the caller's images, made from
                                                welkin_vulkan_image_infos, bound to memory, outliving the object */
  uint32_t image_count;                      /* length of `images`; unused if that is null */
} WelkinVulkanCreateInfo;

/* Source of the dome's radiance. */
typedef enum WelkinVulkanSource {
  WELKIN_VULKAN_ANALYTIC = 0, /* formulas and gradients: exact at every hour */
  WELKIN_VULKAN_CUBEMAP = 1   /* baked cubemaps, blended: two texture reads a pixel */
} WelkinVulkanSource;

/* Projection of the dome onto the viewport. */
typedef enum WelkinVulkanProjection {
  WELKIN_VULKAN_PERSPECTIVE = 0,
  WELKIN_VULKAN_FISHEYE = 1 /* the upper hemisphere, looking up: zenith in the centre, horizon on the rim, north up,
                               east to the left; the distance from the centre is linear in the angle from the zenith;
                               0 outside the circle */
} WelkinVulkanProjection;

/* One drawing of the dome. Zero-initialise it, then set the fields that the projection needs. */
typedef struct WelkinVulkanView {
  WELKIN_STRUCT_SIZE(WelkinVulkanView);
  WelkinVulkanSource source;
  WelkinVulkanProjection projection;
  float inverse_view_projection[16]; /* perspective only: inverse of projection x view rotation, column-major, without
                                        the camera's translation, for Vulkan's y-down device coordinates; any depth
                                        convention */
  float aspect;                      /* fisheye only: width / height of the viewport, > 0 */
  float depth;                       /* depth of the dome, in [0, 1]: 1, or 0 with reversed depth */
  uint32_t discs;                    /* 1: draws the sun, the moon and the stars too; 0: the dome alone */
  float opacity; /* in (0, 1): blends the dome over the picture, for the second sky of a cross-blend; the colour
                    format must support blending. 0 or 1: the dome replaces the picture */
} WelkinVulkanView;

/* Bytes of device memory that the object holds now. */
typedef struct WelkinVulkanMemory {
  WELKIN_STRUCT_SIZE(WelkinVulkanMemory);
  uint32_t reserved;     /* 0 */
  VkDeviceSize images;   /* gradients, stars, modes and cubemaps */
  VkDeviceSize uniforms; /* host-visible */
  VkDeviceSize staging;  /* host-visible; 0 after welkin_vulkan_free_staging */
} WelkinVulkanMemory;

/* Creates images, buffers, pipelines and descriptor sets for `sky`, which need not outlive the call. On an error *out
 * is null, and `message`, which may be null, has the reason. Possible errors: WELKIN_ERROR_ARGUMENT,
 * WELKIN_ERROR_MEMORY and WELKIN_ERROR_DEVICE. */
WELKIN_API WelkinResult welkin_vulkan_create(const WelkinVulkanCreateInfo* info, const WelkinSky* sky,
                                             WelkinVulkanSky** out, WelkinMessage* message);

/* Describes the images of a sky, for a caller that makes them. Writes at most *count infos, then sets *count to the
 * number of images. `infos` may be null: then only *count is written. */
WELKIN_API WelkinResult welkin_vulkan_image_infos(const WelkinSky* sky, uint32_t* count, VkImageCreateInfo* infos);

/* Destroys the object. No command buffer that uses it may still be running. Null is allowed. */
WELKIN_API void welkin_vulkan_destroy(WelkinVulkanSky* object);

/* Records the upload of the images and the making of the cubemaps' mips. Call it once, outside a render pass, for the
 * graphics queue family that will read them. Every later shader on that queue can then read the images. A second call,
 * or one after welkin_vulkan_free_staging, is WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_vulkan_record_upload(WelkinVulkanSky* object, VkCommandBuffer commands);

/* Frees the memory behind the upload. Call it once the upload's submission has finished. Null is allowed. */
WELKIN_API void welkin_vulkan_free_staging(WelkinVulkanSky* object);

/* Writes the constants of frame index `frame` < frames_in_flight and points its descriptor set at the sample's
 * cubemaps. No command buffer that uses this frame index may be running, or be recorded and not yet submitted. A sample
 * whose cubemaps or modes do not fit the sky is WELKIN_ERROR_ARGUMENT; other samples of another sky are not noticed. */
WELKIN_API WelkinResult welkin_vulkan_update(WelkinVulkanSky* object, uint32_t frame, const WelkinSkySample* sample);

/* Replaces the ambient light in the constants of a frame index by that of a cross-blend from welkin_sample_blend. Call
 * it after welkin_vulkan_update of that frame index, else it is WELKIN_ERROR_ARGUMENT. modes.glsl
 * lights that frame where the skies were baked as a family. Any other cross-blend has no modes: light that frame with
 * ambient.glsl. There modes.glsl gives the first two bands of the coefficients alone, as it does for a file without
 * modes. */
WELKIN_API WelkinResult welkin_vulkan_update_ambient(WelkinVulkanSky* object, uint32_t frame,
                                                     const WelkinSkySample* blended);

/* Records one triangle that covers the viewport, inside dynamic rendering with the formats of the create info. The
 * caller has set viewport and scissor. Leaves its pipeline, its set 0 and its push constants bound.
 * WELKIN_ERROR_ARGUMENT before the upload was recorded or the frame index updated, for cubemaps that the sky lacks, and
 * for a view out of range. WELKIN_ERROR_DEVICE for an opacity in (0, 1) with a colour format that cannot blend. */
WELKIN_API WelkinResult welkin_vulkan_draw_dome(const WelkinVulkanSky* object, VkCommandBuffer commands, uint32_t frame,
                                                const WelkinVulkanView* view);

/* Layout of the descriptor set, for the caller's pipelines. Vertex, fragment and compute shaders can read it.
 * VK_NULL_HANDLE for a null object. */
WELKIN_API VkDescriptorSetLayout welkin_vulkan_descriptor_set_layout(const WelkinVulkanSky* object);

/* Descriptor set of frame index `frame`, as welkin_vulkan_update last wrote it. VK_NULL_HANDLE for a null object and
 * for a frame that is not below frames_in_flight. */
WELKIN_API VkDescriptorSet welkin_vulkan_descriptor_set(const WelkinVulkanSky* object, uint32_t frame);

/* Bytes of device memory that the object holds now. Images of the caller do not count. */
WELKIN_API WelkinResult welkin_vulkan_memory(const WelkinVulkanSky* object, WelkinVulkanMemory* memory);

#ifdef __cplusplus
}
#endif

#endif
