// SPDX-License-Identifier: Apache-2.0
// Pictures of a baked sky at an hour, drawn by the runtime's own passes. Radiance is in scene units.
#pragma once

#include "render/camera.h"
#include "render/offscreen.h"
#include "render/runtime_sky.h"
#include "render/sphere_pipeline.h"

namespace welkin::render {

/// Ambient light of the spheres, with the values of spheres_push.h.
enum class SkyLight : uint32_t {
  flat = WELKIN_LIGHT_FLAT,  ///< one colour: the mean over all normals
  sh = WELKIN_LIGHT_SH,
  both = WELKIN_LIGHT_BOTH
};

class Views {
 public:
  /// Creates the runtime's Vulkan objects and uploads the sky. `sky` and `device` must outlive the object.
  Views(VulkanDevice& device, const Sky& sky, WelkinVulkanSource source);

  /// Sets the hour of the following pictures. Throws Error(usage) when it is not finite.
  void setTime(double time_h, bool tint = true) { runtime_.setTime(time_h, tint); }
  const WelkinSkySample& sample() const { return runtime_.sample(); }

  /// Draws the upper hemisphere, mapped by welkinFisheyeDirection of view.glsl.
  FloatImage dome(uint32_t width, uint32_t height, bool discs);
  FloatImage perspective(uint32_t width, uint32_t height, const Camera& camera, bool discs);
  /// Draws a row of spheres in front of the sky; see spheres.frag.
  FloatImage spheres(uint32_t width, uint32_t height, const Camera& camera, SkyLight light);

  const WelkinVulkanSky* runtime() const { return runtime_.get(); }

 private:
  FloatImage drawDome(uint32_t width, uint32_t height, const WelkinVulkanView& view);

  VulkanDevice& device_;
  WelkinVulkanSource source_;
  RuntimeSky runtime_;
  SpherePipeline spheres_;
};

/// A horizontal camera that looks towards the sun, or towards the moon when it is up after nautical twilight.
Camera towardsLight(const WelkinSkySample& sample);

}  // namespace welkin::render
