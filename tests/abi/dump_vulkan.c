/* SPDX-License-Identifier: Apache-2.0
 * Draws a sky's dome through welkin_vulkan.h as a C99 program and prints what comes back. It is compiled against the
 * header of a release and against today's, as dump.c. Guard bytes stand around every struct that the two share.
 *   dump_vulkan SKY.welkin      exit status 1 when a call fails or a guard byte changed; "skipped: " without a device
 */
#include "device.h"

static void draw(const WelkinVulkanSky* object, VkImage image, VkImageView target, const WelkinVulkanView* dome) {
  VkImageMemoryBarrier barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                  NULL,
                                  0,
                                  VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                                  VK_IMAGE_LAYOUT_UNDEFINED,
                                  VK_IMAGE_LAYOUT_GENERAL,
                                  VK_QUEUE_FAMILY_IGNORED,
                                  VK_QUEUE_FAMILY_IGNORED,
                                  VK_NULL_HANDLE,
                                  {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
  VkMemoryBarrier read = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, NULL, VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                          VK_ACCESS_HOST_READ_BIT};
  VkRenderingAttachmentInfo colour;
  VkRenderingInfo rendering;
  VkViewport viewport = {0, 0, SIZE, SIZE, 0, 1};
  VkRect2D area = {{0, 0}, {SIZE, SIZE}};
  memset(&colour, 0, sizeof colour);
  colour.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  colour.imageView = target;
  colour.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  memset(&rendering, 0, sizeof rendering);
  rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  rendering.renderArea = area;
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = 1;
  rendering.pColorAttachments = &colour;
  barrier.image = image;
  begin();
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, 0, 0,
                       NULL, 0, NULL, 1, &barrier);
  vkCmdBeginRendering(commands, &rendering);
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &area);
  if (welkin_vulkan_draw_dome(object, commands, 0, dome) != WELKIN_OK) fail("welkin_vulkan_draw_dome");
  vkCmdEndRendering(commands);
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &read,
                       0, NULL, 0, NULL);
  submit();
}

static void printMemory(const WelkinVulkanSky* object) {
  GUARDED(WelkinVulkanMemory) memory;
  memory.value.struct_size = sizeof memory.value;
  CALL(memory, welkin_vulkan_memory(object, &memory.value));
  printf("memory %lu %lu %lu\n", (unsigned long)memory.value.images, (unsigned long)memory.value.uniforms,
         (unsigned long)memory.value.staging);
}

static void printImages(const WelkinSky* sky) {
  VkImageCreateInfo infos[8 + 1];
  uint32_t count = 0, i;
  if (welkin_vulkan_image_infos(sky, &count, NULL) != WELKIN_OK || count == 0 || count > 8)
    fail("the number of images");
  memset(infos, 0xa5, sizeof infos);
  if (welkin_vulkan_image_infos(sky, &count, infos) != WELKIN_OK) fail("welkin_vulkan_image_infos");
  for (i = 0; i < sizeof infos[0]; ++i)
    if (((const unsigned char*)&infos[count])[i] != 0xa5) fail("an image too many");
  for (i = 0; i < count; ++i)
    printf("image %u: format %d, %u x %u, %u mips, %u layers, usage %x\n", (unsigned)i, (int)infos[i].format,
           (unsigned)infos[i].extent.width, (unsigned)infos[i].extent.height, (unsigned)infos[i].mipLevels,
           (unsigned)infos[i].arrayLayers, (unsigned)infos[i].usage);
}

static void drawSky(const WelkinSky* sky) {
  GUARDED(WelkinVulkanCreateInfo) create;
  GUARDED(WelkinVulkanMemoryCallbacks) callbacks;
  GUARDED(WelkinVulkanView) view;
  GUARDED(WelkinSkySample) sample;
  GUARDED(WelkinMessage) message;
  WelkinVulkanSky* object = NULL;
  VkImage image = VK_NULL_HANDLE;
  VkImageView target = VK_NULL_HANDLE;
  const float* pixels = makeTarget(&image, &target);
  int pieces = 0, i;
  memset(&create.value, 0, sizeof create.value);
  memset(&callbacks.value, 0, sizeof callbacks.value);
  callbacks.value.struct_size = sizeof callbacks.value;
  callbacks.value.user = &pieces;
  callbacks.value.allocate = allocate;
  callbacks.value.free = release;
  create.value.struct_size = sizeof create.value;
  create.value.api_version = VK_API_VERSION_1_3;
  create.value.get_instance_proc_addr = vkGetInstanceProcAddr;
  create.value.instance = instance;
  create.value.physical_device = physical;
  create.value.device = device;
  create.value.frames_in_flight = 2;
  create.value.colour_format = VK_FORMAT_R32G32B32A32_SFLOAT;
  create.value.memory = &callbacks.value;
  guard(callbacks.before, callbacks.after);
  guard(message.before, message.after);
  CALL(create, welkin_vulkan_create(&create.value, sky, &object, &message.value));
  check("the callbacks", callbacks.before, callbacks.after);
  check("the message", message.before, message.after);
  printf("%d pieces of memory\n", pieces);
  printMemory(object);
  begin();
  if (welkin_vulkan_record_upload(object, commands) != WELKIN_OK) fail("welkin_vulkan_record_upload");
  submit();
  welkin_vulkan_free_staging(object);
  printMemory(object);
  sample.value.struct_size = sizeof sample.value;
  CALL(sample, welkin_sky_sample(sky, 9.5, &sample.value));
  CALL(sample, welkin_vulkan_update(object, 0, &sample.value));
  CALL(sample, welkin_vulkan_update_ambient(object, 0, &sample.value));
  for (i = 0; i < 2; ++i) {
    memset(&view.value, 0, sizeof view.value);
    view.value.struct_size = sizeof view.value;
    view.value.source = i == 0 ? WELKIN_VULKAN_ANALYTIC : WELKIN_VULKAN_CUBEMAP;
    view.value.projection = WELKIN_VULKAN_FISHEYE;
    view.value.aspect = 1.0F;
    view.value.discs = 1;
    guard(view.before, view.after);
    draw(object, image, target, &view.value);
    check("the view", view.before, view.after);
    floats("dome", pixels, SIZE * SIZE * 4);
  }
  if (welkin_vulkan_descriptor_set(object, 1) == VK_NULL_HANDLE ||
      welkin_vulkan_descriptor_set(object, 2) != VK_NULL_HANDLE)
    fail("descriptor sets");
  welkin_vulkan_destroy(object);
  if (pieces != 0) fail("memory that is not given back");
}

int main(int argc, char** argv) {
  WelkinSky* sky = NULL;
  WelkinMessage message;
  if (argc != 2) return 1;
  makeDevice();
  if (welkin_sky_open_file(argv[1], &sky, &message) != WELKIN_OK) {
    fprintf(stderr, "%s\n", message.text);
    return 1;
  }
  printImages(sky);
  drawSky(sky);
  welkin_sky_close(sky);
  return 0;
}
