/* SPDX-License-Identifier: Apache-2.0
 *
 * Welkin on Vulkan 1.3: the sky dome, and the descriptor set that lights a scene with the sky's ambient light. C ABI.
 *
 * The caller owns the instance, the device and every command buffer. The library creates images, buffers and pipelines
 * once, records into the caller's command buffers, and never submits, waits or locks. After creation it allocates
 * nothing, on the host or on the device. It links no Vulkan loader.
 *
 * Needs of the device: Vulkan 1.3 with dynamicRendering and synchronization2 enabled; no extension, no other feature.
 *
 * At load time                                   Every frame, once the GPU is done with this frame index
 *   1. welkin_vulkan_create                        1. welkin_sky_sample
 *   2. welkin_vulkan_record_upload, submit         2. welkin_vulkan_update
 *   3. when that submission has finished:          3. bind welkin_vulkan_descriptor_set in the caller's own passes
 *      welkin_vulkan_free_staging                  4. welkin_vulkan_draw_dome inside dynamic rendering
 *
 * Shaders: welkin/sky_bindings.h, ambient.glsl, modes.glsl, dome.glsl and discs.glsl, of the folder shaders/welkin. A
 * file with modes (WelkinSkyInfo::mode_count) is lit through modes.glsl, which shows welkin_sky_irradiance;
 * ambient.glsl shows welkin_sample_irradiance of every file.
 *
 * Threads: there is no global state; distinct objects may be used at once. Calls on one object must not overlap, except
 * that the functions taking a const WelkinVulkanSky and welkin_vulkan_draw_dome may run on any number of threads at
 * once, with different command buffers.
 */
#ifndef WELKIN_WELKIN_VULKAN_H
#define WELKIN_WELKIN_VULKAN_H

#include <vulkan/vulkan_core.h>
#include <welkin/welkin.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT 16

typedef struct WelkinVulkanSky WelkinVulkanSky;

/* Device memory from the caller's allocator. */
typedef struct WelkinVulkanAllocation {
  VkDeviceMemory memory;
  VkDeviceSize offset; /* bytes; a multiple of the required alignment */
  void* mapped;        /* host address of `offset`, valid until the memory is freed, if host-visible was required */
  void* user;          /* not read by the library */
} WelkinVulkanAllocation;

/* Lets an allocator of the caller, such as VMA, own the device memory. welkin_vulkan_create makes at most three
 * allocations: the images, the uniforms and the staging buffer. Nothing is allocated later. */
typedef struct WelkinVulkanMemoryCallbacks {
  void* user;
  VkResult (*allocate)(void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags required,
                       VkMemoryPropertyFlags preferred, WelkinVulkanAllocation* allocation);
  void (*free)(void* user, const WelkinVulkanAllocation* allocation);
} WelkinVulkanMemoryCallbacks;

/* Zero-initialise, then set what is needed. */
typedef struct WelkinVulkanCreateInfo {
  uint32_t struct_size; /* sizeof(WelkinVulkanCreateInfo) */
  uint32_t api_version; /* apiVersion of the caller's VkApplicationInfo, at least VK_API_VERSION_1_3 */
  PFN_vkGetInstanceProcAddr get_instance_proc_addr;
  VkInstance instance;
  VkPhysicalDevice physical_device;
  VkDevice device;
  const VkAllocationCallbacks* allocator;    /* for Vulkan's host memory; may be null; must outlive the object */
  VkPipelineCache pipeline_cache;            /* may be null */
  uint32_t frames_in_flight;                 /* 1..WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT */
  VkFormat colour_format;                    /* of the dome's colour attachment; it writes radiance, and alpha 1 */
  VkFormat depth_format;                     /* of the dome's pass; VK_FORMAT_UNDEFINED without a depth attachment */
  VkFormat stencil_format;                   /* of the dome's pass; VK_FORMAT_UNDEFINED without a stencil attachment */
  VkCompareOp depth_compare;                 /* of the dome's depth test, which writes no depth; unused without depth */
  VkSampleCountFlagBits samples;             /* 0 counts as 1 */
  const WelkinVulkanMemoryCallbacks* memory; /* null: the library allocates. Copied: need not outlive the call */
  const VkImage* images;                     /* null: the library makes its images. Else the caller's, made as
                                                welkin_vulkan_image_infos says and bound to memory; they outlive the object */
  uint32_t image_count;                      /* length of `images`; unused if that is null */
} WelkinVulkanCreateInfo;

/* Source of the dome's radiance. */
typedef enum WelkinVulkanSource {
  WELKIN_VULKAN_ANALYTIC = 0, /* formulas and gradients: exact at every hour */
  WELKIN_VULKAN_CUBEMAP = 1   /* baked cubemaps, blended: two texture reads a pixel */
} WelkinVulkanSource;

typedef enum WelkinVulkanProjection {
  WELKIN_VULKAN_PERSPECTIVE = 0,
  WELKIN_VULKAN_FISHEYE = 1 /* the upper hemisphere, looking up: zenith in the centre, horizon on the rim, north up,
                               east to the left; the angle from the zenith grows linearly; 0 outside the circle */
} WelkinVulkanProjection;

typedef struct WelkinVulkanView {
  WelkinVulkanSource source;
  WelkinVulkanProjection projection;
  float inverse_view_projection[16]; /* perspective: column-major inverse of projection x view rotation, without the
                                        camera's translation, for Vulkan's y-down device coordinates; any depth
                                        convention */
  float aspect;                      /* fisheye: width / height of the viewport, > 0 */
  float depth;                       /* depth of the dome, in [0, 1]: 1, or 0 with reversed depth */
  uint32_t discs;                    /* 1: draws the sun, the moon and the stars too; 0: the dome alone */
  float opacity; /* in (0, 1): the dome is blended over the picture, for the second sky of a cross-blend,
                    which needs a colour format that blends; 0 and 1: it replaces the picture */
} WelkinVulkanView;

/* Bytes of device memory that the object holds now. */
typedef struct WelkinVulkanMemory {
  VkDeviceSize images;   /* gradients, stars, modes and cubemaps */
  VkDeviceSize uniforms; /* host-visible */
  VkDeviceSize staging;  /* host-visible; 0 after welkin_vulkan_free_staging */
} WelkinVulkanMemory;

/* Creates images, buffers, pipelines and descriptor sets for `sky`, which need not outlive the call. On an error *out
 * is null, and `message`, if given, has the reason: WELKIN_ERROR_ARGUMENT, WELKIN_ERROR_MEMORY or WELKIN_ERROR_DEVICE.
 */
WELKIN_API WelkinResult welkin_vulkan_create(const WelkinVulkanCreateInfo* info, const WelkinSky* sky,
                                             WelkinVulkanSky** out, WelkinMessage* message);

/* Descriptions of a sky's images, for a caller that makes them. Writes at most *count infos, and sets *count to their
 * number. `infos` may be null: then only the number is given. */
WELKIN_API WelkinResult welkin_vulkan_image_infos(const WelkinSky* sky, uint32_t* count, VkImageCreateInfo* infos);

/* Destroys the object. No command buffer that uses it may still be running. Null is allowed. */
WELKIN_API void welkin_vulkan_destroy(WelkinVulkanSky* object);

/* Records the upload of the images and makes the cubemaps' mips, once, outside a render pass, on the graphics queue
 * family that will read them. Leaves them readable by every later shader on that queue. A second call is
 * WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_vulkan_record_upload(WelkinVulkanSky* object, VkCommandBuffer commands);

/* Frees the memory behind the upload, once its submission has finished. */
WELKIN_API void welkin_vulkan_free_staging(WelkinVulkanSky* object);

/* Writes the constants of frame index `frame` < frames_in_flight and points its descriptor set at the sample's
 * cubemaps. No command buffer that uses this frame index may be running, or be recorded and not yet submitted.
 * WELKIN_ERROR_ARGUMENT for a sample of another sky where it can be told: its cubemaps or modes do not fit. */
WELKIN_API WelkinResult welkin_vulkan_update(WelkinVulkanSky* object, uint32_t frame, const WelkinSkySample* sample);

/* Puts the ambient light of another sample, a cross-blend of welkin_sample_blend, into the constants of a frame index
 * that welkin_vulkan_update has just written. It has no modes: light that frame through ambient.glsl. modes.glsl then
 * shows the first two bands of the coefficients alone, as it does of a file without modes. */
WELKIN_API WelkinResult welkin_vulkan_update_ambient(WelkinVulkanSky* object, uint32_t frame,
                                                     const WelkinSkySample* blended);

/* Records one triangle that covers the viewport, inside dynamic rendering with the formats of the create info. The
 * caller has set viewport and scissor. Leaves its pipeline, its set 0 and push constants bound. */
WELKIN_API WelkinResult welkin_vulkan_draw_dome(const WelkinVulkanSky* object, VkCommandBuffer commands, uint32_t frame,
                                                const WelkinVulkanView* view);

/* Layout of the descriptor set, for the caller's pipelines. Visible to vertex, fragment and compute shaders. */
WELKIN_API VkDescriptorSetLayout welkin_vulkan_descriptor_set_layout(const WelkinVulkanSky* object);

/* Descriptor set of frame index `frame`, as welkin_vulkan_update last wrote it. VK_NULL_HANDLE for a frame that is not
 * below frames_in_flight. */
WELKIN_API VkDescriptorSet welkin_vulkan_descriptor_set(const WelkinVulkanSky* object, uint32_t frame);

/* Bytes of device memory that the object holds now; those of the caller's images do not count. */
WELKIN_API WelkinResult welkin_vulkan_memory(const WelkinVulkanSky* object, WelkinVulkanMemory* memory);

#ifdef __cplusplus
}
#endif

#endif
