// SPDX-License-Identifier: Apache-2.0
// Records the passes of the level picture.
#include "render/level_view.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "render/set_writer.h"

namespace welkin::render {

/// The images and constants of one view. The descriptor set points at them.
struct LevelView::Target {
  Target(const VulkanDevice& device, VkExtent2D extent, VkDescriptorSet descriptor_set,
         const render::shaders::LevelConstants& c)
      : albedo(device, LevelPipelines::kSurfaceFormat, extent, kSurfaceUsage),
        normal(device, LevelPipelines::kSurfaceFormat, extent, kSurfaceUsage),
        emission(device, Offscreen::kFormat, extent, kSurfaceUsage),
        depth(device, LevelPipelines::kDepthFormat, extent,
              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT),
        occlusion(device, extent),
        constants(device, sizeof(render::shaders::LevelConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
        set(descriptor_set) {
    *constants.as<render::shaders::LevelConstants>() = c;
  }

  static constexpr VkImageUsageFlags kSurfaceUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  Image albedo;
  Image normal;
  Image emission;
  Image depth;
  OcclusionImages occlusion;
  Buffer constants;
  VkDescriptorSet set;
};

/// All that a picture of one size is drawn into.
struct LevelView::Frame {
  Frame(VulkanDevice& device, VkExtent2D extent, const VkDescriptorSet (&sets)[2])
      : half{std::max(extent.width / 2, 1U), std::max(extent.height / 2, 1U)},
        radiance(device, extent.width, extent.height),
        target(device, extent, sets[0], {}),
        mirror(device, half, sets[1], {}),
        copy(device, Offscreen::kFormat, extent, kUsage),
        reflection(device, Offscreen::kFormat, half, kUsage) {}

  static constexpr VkImageUsageFlags kUsage =
      VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  VkExtent2D half;
  Offscreen radiance;
  Target target, mirror;
  Image copy, reflection;
};

namespace {

VkDescriptorPool createSets(VkDevice device, VkDescriptorSetLayout layout, VkDescriptorSet (&sets)[2]) {
  const VkDescriptorPoolSize sizes[3] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 2},
                                         {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2 * 5},
                                         {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2 * (WELKIN_LEVEL_BINDINGS - 6)}};
  VkDescriptorPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  info.maxSets = 2;
  info.poolSizeCount = 3;
  info.pPoolSizes = sizes;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  require(vkCreateDescriptorPool(device, &info, nullptr, &pool), "vkCreateDescriptorPool");
  const VkDescriptorSetLayout layouts[2] = {layout, layout};
  VkDescriptorSetAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocate.descriptorPool = pool;
  allocate.descriptorSetCount = 2;
  allocate.pSetLayouts = layouts;
  const VkResult result = vkAllocateDescriptorSets(device, &allocate, sets);
  if (result != VK_SUCCESS) vkDestroyDescriptorPool(device, pool, nullptr);
  require(result, "vkAllocateDescriptorSets");
  return pool;
}

void recordCopy(VkCommandBuffer commands, Image& from, Image& to) {
  from.use(commands, kCopiedFrom);
  to.use(commands, kCopiedTo, true);
  VkImageCopy region{};
  region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.extent = {from.extent().width, from.extent().height, 1};
  vkCmdCopyImage(commands, from.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.handle(),
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void recordClear(VkCommandBuffer commands, Image& image) {
  image.use(commands, kDrawnColour, true);
  const VkRenderingAttachmentInfo colour = attachmentOf(image, kDrawnColour.layout, VK_ATTACHMENT_LOAD_OP_CLEAR);
  beginRendering(commands, image.extent(), 1, &colour, nullptr);
  vkCmdEndRendering(commands);
}

}  // namespace

LevelView::LevelView(VulkanDevice& device, const Sky& sky, const level::Scene& scene, const LevelOptions& options,
                     WelkinLevel* baked)
    : device_(device),
      scene_(scene),
      options_(options),
      sky_(device, sky, LevelPipelines::kDepthFormat, VK_COMPARE_OP_EQUAL),
      mesh_(device, scene, double{sky.info().luminance_unit}, options.direct),
      lamps_(device, scene, double{sky.info().luminance_unit}),
      blockers_(device, levelTree(scene.lights.empty() ? level::Scene{} : scene)),
      volume_(baked == nullptr ? nullptr : std::make_unique<LevelVolume>(device, *baked, options.parts)),
      reflection_(device, sky_),
      pipelines_(device, sky_.layout(), volume_ ? volume_->layout() : VkDescriptorSetLayout{VK_NULL_HANDLE},
                 reflection_.layout(), sky.info().mode_count > 0),
      occlusion_(device, pipelines_.layout()),
      untraced_(device, {1, 1, {0.0F, 0.0F, 0.0F, 0.0F}}),
      times_(device) {
  options_.probes = volume_ != nullptr;
  pool_ = createSets(device.device(), pipelines_.setLayout(), sets_);
}

LevelView::~LevelView() {
  vkDestroyDescriptorPool(device_.device(), pool_, nullptr);
}

void LevelView::setOptions(const LevelOptions& options) {
  const bool probes = options_.probes;
  options_ = options;
  options_.probes = probes;
  if (options.coarse > 0.0) mesh_.simplify();
  if (volume_) volume_->setParts(options.parts);
}

void LevelView::bind(VkCommandBuffer commands, VkPipeline pipeline, const Target& target) const {
  VkDescriptorSet sets[4] = {sky_.set(), target.set};
  uint32_t count = 2;
  if (volume_) sets[count++] = volume_->set();
  sets[count++] = reflection_.set();
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.layout(), 0, count, sets, 0, nullptr);
}

void LevelView::beginOver(VkCommandBuffer commands, Target& target, const ImageUse& depth_use, Image& radiance,
                          VkAttachmentLoadOp load, VkPipeline pipeline) {
  target.depth.use(commands, depth_use);
  radiance.use(commands, kDrawnColour, load == VK_ATTACHMENT_LOAD_OP_CLEAR);
  const VkRenderingAttachmentInfo colour = attachmentOf(radiance, kDrawnColour.layout, load);
  const VkRenderingAttachmentInfo depth = attachmentOf(target.depth, depth_use.layout, VK_ATTACHMENT_LOAD_OP_LOAD);
  beginRendering(commands, radiance.extent(), 1, &colour, &depth);
  bind(commands, pipeline, target);
}

LevelView::ShadowMap::ShadowMap(const VulkanDevice& device, uint32_t size)
    : image(device, LevelPipelines::kDepthFormat, {size, size},
            VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT) {}

LevelView::ShadowMap& LevelView::shadow() {
  const auto found = shadows_.find(options_.shadow_size);
  if (found != shadows_.end()) return found->second;
  return shadows_
      .emplace(std::piecewise_construct, std::forward_as_tuple(options_.shadow_size),
               std::forward_as_tuple(device_, options_.shadow_size))
      .first->second;
}

LevelView::Frame& LevelView::frameOf(uint32_t width, uint32_t height) {
  const auto fits = [&](const VkExtent2D& extent) { return extent.width == width && extent.height == height; };
  if (!frame_ || !fits(frame_->copy.extent())) {
    frame_.reset();  // first, so that both are never there at once
    frame_ = std::make_unique<Frame>(device_, VkExtent2D{width, height}, sets_);
  }
  return *frame_;
}

void LevelView::recordShadow(VkCommandBuffer commands, const Target& target) {
  ShadowMap& map = shadow();
  const WelkinLight* light = lightOf(sample());
  std::array<float, 3> towards{};
  if (light != nullptr) std::copy_n(light->direction, 3, towards.begin());
  if (map.drawn_for == towards) return;
  map.drawn_for = towards;
  map.image.use(commands, kDrawnDepth, true);
  VkRenderingAttachmentInfo depth =
      attachmentOf(map.image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
  depth.clearValue.depthStencil.depth = 1.0F;
  beginRendering(commands, map.image.extent(), 0, nullptr, &depth);
  if (light != nullptr) {
    bind(commands, pipelines_.shadow, target);
    mesh_.record(commands, nullptr, false);
  }
  vkCmdEndRendering(commands);
  map.image.use(commands, kSampledDepth);
}

void LevelView::recordSurface(VkCommandBuffer commands, Target& target, bool mirrored) {
  target.albedo.use(commands, kDrawnColour, true);
  target.normal.use(commands, kDrawnColour, true);
  target.emission.use(commands, kDrawnColour, true);
  target.depth.use(commands, kDrawnDepth, true);
  constexpr auto kColourLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  const VkRenderingAttachmentInfo surface[3] = {
      attachmentOf(target.albedo, kColourLayout, VK_ATTACHMENT_LOAD_OP_CLEAR),
      attachmentOf(target.normal, kColourLayout, VK_ATTACHMENT_LOAD_OP_CLEAR),
      attachmentOf(target.emission, kColourLayout, VK_ATTACHMENT_LOAD_OP_CLEAR)};
  const VkRenderingAttachmentInfo depth =
      attachmentOf(target.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
  beginRendering(commands, target.depth.extent(), 3, surface, &depth);
  bind(commands, pipelines_.surface, target);
  mesh_.record(commands, &target.constants.as<render::shaders::LevelConstants>()->view_projection, mirrored,
               options_.coarse / target.depth.extent().height);
  vkCmdEndRendering(commands);
  target.albedo.use(commands, kSampled);
  target.normal.use(commands, kSampled);
  target.emission.use(commands, kSampled);
}

void LevelView::recordScene(VkCommandBuffer commands, Target& target, Image& radiance, bool mirrored,
                            const WelkinVulkanView* dome) {
  recordSurface(commands, target, mirrored);
  passed(commands, "surfaces", mirrored);
  occlusion_.record(commands, target.set, target.depth, target.occlusion, options_.occlusion);
  passed(commands, "occlusion", mirrored);
  beginOver(commands, target, kTestedDepth, radiance, VK_ATTACHMENT_LOAD_OP_CLEAR,
            options_.glossy ? pipelines_.glossy : pipelines_.light);
  vkCmdDraw(commands, 3, 1, 0, 0);
  vkCmdEndRendering(commands);
  passed(commands, "light", mirrored);
  if (dome != nullptr) {
    beginOver(commands, target, kTestedDepth, radiance, VK_ATTACHMENT_LOAD_OP_LOAD, pipelines_.light);
    sky_.recordDome(commands, *dome);
    vkCmdEndRendering(commands);
    passed(commands, "dome", mirrored);
  }
  recordProbes(commands, target, radiance);
  recordGlass(commands, target, radiance);
  passed(commands, "probes, glass", mirrored);
}

void LevelView::recordGlass(VkCommandBuffer commands, Target& target, Image& radiance) {
  if (!mesh_.hasGlass()) return;
  beginOver(commands, target, kTestedDepth, radiance, VK_ATTACHMENT_LOAD_OP_LOAD, pipelines_.glass);
  mesh_.recordGlass(commands, pipelines_.layout());
  vkCmdEndRendering(commands);
}

void LevelView::setProbes(std::span<const ProbeSphere> probes) {
  probes_.reset();
  if (probes.empty()) return;
  probes_ = std::make_unique<Buffer>(device_, probes.size_bytes(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  std::memcpy(probes_->as<ProbeSphere>(), probes.data(), probes.size_bytes());
}

void LevelView::recordProbes(VkCommandBuffer commands, Target& target, Image& radiance) {
  if (!probes_) return;
  beginOver(commands, target, kDrawnDepth, radiance, VK_ATTACHMENT_LOAD_OP_LOAD, pipelines_.probes);
  const VkDeviceSize offset = 0;
  const VkBuffer probes = probes_->handle();
  vkCmdBindVertexBuffers(commands, 0, 1, &probes, &offset);
  vkCmdDraw(commands, ProbeSphere::kVertices, static_cast<uint32_t>(probes_->bytes() / sizeof(ProbeSphere)), 0, 0);
  vkCmdEndRendering(commands);
}

void LevelView::recordWater(VkCommandBuffer commands, Target& target, Image& radiance, Image& copy, Image& reflection) {
  recordCopy(commands, radiance, copy);
  copy.use(commands, kSampled);
  reflection.use(commands, kSampled);
  beginOver(commands, target, kTestedDepth, radiance, VK_ATTACHMENT_LOAD_OP_LOAD, pipelines_.water);
  vkCmdDraw(commands, 12, 1, 0, 0);
  vkCmdEndRendering(commands);
}

void LevelView::describe(const Target& target, const Image& copy, const Image& reflection, const Image& traced) {
  SetWriter writer(target.set);
  const auto sampled = [&](uint32_t binding, const Image& image) {
    writer.image(binding, pipelines_.sampler(), image, kSampled.layout);
  };
  writer.buffer(WELKIN_LEVEL_CONSTANTS, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, target.constants.handle());
  writer.buffer(WELKIN_LEVEL_INSTANCES, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, mesh_.instances());
  writer.buffer(WELKIN_LEVEL_CONTACT, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, mesh_.contact());
  writer.buffer(WELKIN_LEVEL_LAMPS, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, lamps_.handle());
  writer.buffer(WELKIN_LEVEL_BOXES, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, blockers_.boxes());
  writer.buffer(WELKIN_LEVEL_TRIANGLES, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, blockers_.triangles());
  writer.image(WELKIN_LEVEL_SHADOW, pipelines_.shadowSampler(), shadow().image, kSampledDepth.layout);
  writer.image(WELKIN_LEVEL_DEPTH, pipelines_.sampler(), target.depth, kTestedDepth.layout);
  sampled(WELKIN_LEVEL_ALBEDO, target.albedo);
  sampled(WELKIN_LEVEL_NORMAL, target.normal);
  sampled(WELKIN_LEVEL_EMISSION, target.emission);
  sampled(WELKIN_LEVEL_NOISY, target.occlusion.noisy);
  sampled(WELKIN_LEVEL_VISIBILITY, target.occlusion.visibility);
  sampled(WELKIN_LEVEL_SCENE, copy);
  sampled(WELKIN_LEVEL_REFLECTION, reflection);
  sampled(WELKIN_LEVEL_TRACED, traced);
  writer.commit(device_.device());
}

FloatImage LevelView::drawOcclusion(uint32_t width, uint32_t height, const Camera& camera,
                                    const f64::Number3& position) {
  Offscreen picture(device_, width, height);
  Target target(device_, {width, height}, sets_[0],
                levelConstants(scene_, sample(), camera, position, width, height, options_, false));
  describe(target, target.emission, target.emission, untraced_.image());  // lavapipe wants every binding written
  return picture.read([&](VkCommandBuffer commands) {
    recordSurface(commands, target, false);
    occlusion_.recordAlone(commands, target.set, target.depth, target.occlusion, picture.image());
  });
}

FloatImage LevelView::drawIrradiance(uint32_t width, uint32_t height, const Camera& camera,
                                     const f64::Number3& position) {
  if (volume_) volume_->update(sample(), position);
  Offscreen picture(device_, width, height);
  Target target(device_, {width, height}, sets_[0],
                levelConstants(scene_, sample(), camera, position, width, height, options_, false));
  target.constants.as<render::shaders::LevelConstants>()->picture[0] = 1.0F;
  describe(target, target.emission, target.emission, untraced_.image());
  return picture.read([&](VkCommandBuffer commands) {
    recordShadow(commands, target);
    recordSurface(commands, target, false);
    occlusion_.record(commands, target.set, target.depth, target.occlusion, options_.occlusion);
    beginOver(commands, target, kTestedDepth, picture.image(), VK_ATTACHMENT_LOAD_OP_CLEAR, pipelines_.light);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
  });
}

FloatImage LevelView::drawPlaces(uint32_t width, uint32_t height, const Camera& camera, const f64::Number3& position) {
  Offscreen picture(device_, width, height);
  Target target(device_, {width, height}, sets_[0],
                levelConstants(scene_, sample(), camera, position, width, height, options_, false));
  describe(target, target.emission, target.emission, untraced_.image());
  return picture.read([&](VkCommandBuffer commands) {
    recordSurface(commands, target, false);
    beginOver(commands, target, kTestedDepth, picture.image(), VK_ATTACHMENT_LOAD_OP_CLEAR, pipelines_.place);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
  });
}

FloatImage LevelView::draw(uint32_t width, uint32_t height, const Camera& camera, const f64::Number3& position,
                           const FloatImage* traced) {
  if (volume_) volume_->update(sample(), position);
  const bool sea = seaBelow(scene_, position).has_value();
  const bool mirrors = sea && options_.reflections;
  Frame& frame = frameOf(width, height);
  Target& target = frame.target;
  for (Target* one : {&target, &frame.mirror})
    *one->constants.as<render::shaders::LevelConstants>() =
        levelConstants(scene_, sample(), camera, position, width, height, options_, sea && one == &frame.mirror);
  std::optional<FloatTexture> uploaded;
  if (traced != nullptr) uploaded.emplace(device_, *traced);
  describe(target, frame.copy, frame.reflection, uploaded ? uploaded->image() : untraced_.image());
  describe(frame.mirror, frame.copy, frame.reflection, untraced_.image());
  WelkinVulkanView dome{};
  dome.source = options_.cubemaps ? WELKIN_VULKAN_CUBEMAP : WELKIN_VULKAN_ANALYTIC;
  dome.projection = WELKIN_VULKAN_PERSPECTIVE;
  std::copy_n(target.constants.as<render::shaders::LevelConstants>()->rays, 16, dome.inverse_view_projection);
  dome.depth = 0.0F;
  dome.discs = 1;
  return frame.radiance.read([&](VkCommandBuffer commands) {
    times_.begin(commands);
    recordShadow(commands, target);
    times_.end(commands, "shadow map");
    if (options_.glossy) reflection_.record(commands);
    if (options_.glossy) times_.end(commands, "reflected sky");
    if (mirrors) recordScene(commands, frame.mirror, frame.reflection, true, nullptr);
    if (mirrors) times_.end(commands, "mirror image");
    if (sea && !mirrors) recordClear(commands, frame.reflection);
    recordScene(commands, target, frame.radiance.image(), false, &dome);
    if (sea) recordWater(commands, target, frame.radiance.image(), frame.copy, frame.reflection);
    times_.end(commands, "sea");
  });
}

}  // namespace welkin::render
