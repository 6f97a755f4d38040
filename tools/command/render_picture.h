// SPDX-License-Identifier: Apache-2.0
// The pictures of a sky of `welkin render`, and what they share with those of a level.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>
#include <welkin/welkin.hpp>

#include "command/render_options.h"
#include "render/picture.h"
#include "render/vulkan_device.h"

namespace welkin::command {

/// The factor on radiance before the tone curve, as --exposure says.
class Exposure {
 public:
  Exposure(const Sky& sky, const std::string& option);
  /// Of pictures of one hour.
  double of(std::span<const render::FloatImage> images) const;

 private:
  std::optional<double> stops_;
  double day_;
};

/// The clock of an hour, wrapped into a day.
std::string hourLabel(double time_h);

/// Calls `draw` for every requested hour and lays the pictures of several hours side by side.
render::Picture drawTimes(const RenderOptions& options, bool sheet,
                          const std::function<std::vector<render::Picture>(double time_h)>& draw);

/// A view of the sky, or a sheet of several views and hours.
render::Picture drawSky(render::VulkanDevice& device, const Sky& sky, const RenderOptions& options);

}  // namespace welkin::command
