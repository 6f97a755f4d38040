// SPDX-License-Identifier: Apache-2.0
// The pictures of `welkin render`.
#pragma once

#include <welkin/welkin.hpp>

#include "command/render_options.h"
#include "render/level_probes.h"
#include "render/level_view.h"
#include "render/picture.h"
#include "render/vulkan_device.h"

namespace welkin::command {

/// A view of the sky, or a sheet of several views and hours.
render::Picture drawSky(render::VulkanDevice& device, const Sky& sky, const RenderOptions& options);

/// A level under the sky, or a sheet of several hours. `baked`: the level whose probes light it, or null. `probes`:
/// those drawn as spheres, or null.
render::Picture drawLevel(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene, WelkinLevel* baked,
                          const render::LevelProbes* probes, const RenderOptions& options);

}  // namespace welkin::command
