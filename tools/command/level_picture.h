// SPDX-License-Identifier: Apache-2.0
// The pictures of a level of `welkin render`.
#pragma once

#include <nlohmann/json.hpp>
#include <welkin/welkin.hpp>

#include "command/render_options.h"
#include "render/level_probes.h"
#include "render/level_view.h"
#include "render/picture.h"

namespace welkin::command {

/// A level under the sky, or a sheet of several hours. `baked`: the level whose probes light it, or null. `probes`:
/// those drawn as spheres, or null.
render::Picture drawLevel(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene, WelkinLevel* baked,
                          const render::LevelProbes* probes, const RenderOptions& options);

/// The same with the path tracer, as --reference, --difference or --compare says. Fills `numbers` with the errors.
/// Throws Error.
render::Picture drawTraced(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene, WelkinLevel* baked,
                           const RenderOptions& options, nlohmann::ordered_json& numbers);

}  // namespace welkin::command
