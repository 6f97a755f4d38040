// SPDX-License-Identifier: Apache-2.0
// Draws pictures of a level under a baked sky: shadow map, surfaces, light, dome, probes, sea. Radiance is in scene
// units.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "render/camera.h"
#include "render/float_texture.h"
#include "render/level_blockers.h"
#include "render/level_frame.h"
#include "render/level_lamps.h"
#include "render/level_mesh.h"
#include "render/level_occlusion.h"
#include "render/level_pipelines.h"
#include "render/level_reflection.h"
#include "render/level_volume.h"
#include "render/offscreen.h"
#include "render/pass_times.h"
#include "render/probe_sphere.h"
#include "render/runtime_sky.h"

namespace welkin::render {

class LevelView {
 public:
  /// `device`, `sky` and `scene` must outlive the object; `baked` too, whose probes give the ambient light. Null: the
  /// open sky does.
  LevelView(VulkanDevice& device, const Sky& sky, const level::Scene& scene, const LevelOptions& options,
            WelkinLevel* baked = nullptr);
  ~LevelView();
  LevelView(const LevelView&) = delete;
  LevelView& operator=(const LevelView&) = delete;

  /// Sets the hour of the following pictures. Throws Error(usage) when it is not finite.
  void setTime(double time_h) { sky_.setTime(time_h, options_.tint); }
  const WelkinSkySample& sample() const { return sky_.sample(); }
  /// Sets the light of the following pictures.
  void setSample(const WelkinSkySample& sample) { sky_.setSample(sample); }

  /// The baked level has had another light than that of the pictures meanwhile, or other lamps.
  void forgetLight() {
    if (volume_) volume_->forgetLight();
  }

  /// Changes how the following pictures are drawn, except for `direct` of emissive surfaces and `probes`. A change of
  /// the tint counts from the next setTime(). The shadow map of each size is kept, and drawn anew where the light has
  /// moved.
  void setOptions(const LevelOptions& options);

  /// Sets the probes of the following pictures and replaces earlier ones. They are spheres of radius
  /// WELKIN_PROBE_RADIUS and albedo 1, each lit by its own probe alone. They neither cast nor receive shadows.
  void setProbes(std::span<const ProbeSphere> probes);

  /// Draws with one sample per pixel. The sky behind the level and the discs are included. `traced`: an irradiance of
  /// surfaces from elsewhere, of the same size, or null. It replaces that of the picture's own lights where its alpha
  /// is 1, but not in the sea's mirror and behind glass.
  FloatImage draw(uint32_t width, uint32_t height, const Camera& camera, const f64::Number3& position,
                  const FloatImage* traced = nullptr);

  /// The device's time of each pass of the last draw().
  std::vector<PassTime> passTimes() const { return times_.read(); }

  /// The irradiance of the surfaces alone, with alpha 1, as draw() lights them. Where there is no surface all is 0. Sea
  /// and glass are not there.
  FloatImage drawIrradiance(uint32_t width, uint32_t height, const Camera& camera, const f64::Number3& position);

  /// The places of the surfaces: unit normal, and the distance along the view axis in metres. Where there is no surface
  /// all is 0. Sea and glass are not there.
  FloatImage drawPlaces(uint32_t width, uint32_t height, const Camera& camera, const f64::Number3& position);

  /// Draws the occlusion alone, whatever the options say: the visibility in [0, 1] as grey, alpha 1. Where there is no
  /// surface all is 0. The sea is not there.
  FloatImage drawOcclusion(uint32_t width, uint32_t height, const Camera& camera, const f64::Number3& position);

 private:
  struct Target;
  struct Frame;
  struct ShadowMap {
    ShadowMap(const VulkanDevice& device, uint32_t size);
    Image image;
    std::optional<std::array<float, 3>> drawn_for;  ///< towards the light; 0 0 0 without one
  };
  /// The images of a picture of this size: those of the last picture, if it had the size.
  Frame& frameOf(uint32_t width, uint32_t height);
  ShadowMap& shadow();
  /// Points the target's set at its images, and at those that the sea reads.
  void describe(const Target& target, const Image& copy, const Image& reflection, const Image& traced);
  /// Draws albedo, normal, emission and depth.
  void recordSurface(VkCommandBuffer commands, Target& target, bool mirrored);
  /// Ends a pass of the picture, or with `mirrored` leaves it to that of the whole mirror image.
  void passed(VkCommandBuffer commands, const char* name, bool mirrored) {
    if (!mirrored) times_.end(commands, name);
  }
  /// Records the level without the sea. With `dome` the sky is drawn where there is no surface.
  void recordScene(VkCommandBuffer commands, Target& target, Image& radiance, bool mirrored,
                   const WelkinVulkanView* dome);
  /// Draws the surfaces that light passes over a scene. They cast no shadow.
  void recordGlass(VkCommandBuffer commands, Target& target, Image& radiance);
  /// Draws the probes over a scene.
  void recordProbes(VkCommandBuffer commands, Target& target, Image& radiance);
  /// Draws the shadow map, unless it is that of the light already.
  void recordShadow(VkCommandBuffer commands, const Target& target);
  void recordWater(VkCommandBuffer commands, Target& target, Image& radiance, Image& copy, Image& reflection);
  /// Begins to draw into `radiance` over a scene. Its depth is tested, and written as `depth_use` says.
  void beginOver(VkCommandBuffer commands, Target& target, const ImageUse& depth_use, Image& radiance,
                 VkAttachmentLoadOp load, VkPipeline pipeline);
  void bind(VkCommandBuffer commands, VkPipeline pipeline, const Target& target) const;

  VulkanDevice& device_;
  const level::Scene& scene_;
  LevelOptions options_;
  RuntimeSky sky_;
  LevelMesh mesh_;
  LevelLamps lamps_;
  LevelBlockers blockers_;
  std::unique_ptr<LevelVolume> volume_;  ///< null without probes' light
  LevelReflection reflection_;
  LevelPipelines pipelines_;
  LevelOcclusion occlusion_;
  std::unique_ptr<Buffer> probes_;         ///< null without probes
  std::map<uint32_t, ShadowMap> shadows_;  ///< by size
  FloatTexture untraced_;
  std::unique_ptr<Frame> frame_;
  PassTimes times_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet sets_[2] = {};  ///< sets of the picture and of its mirror image
};

}  // namespace welkin::render
