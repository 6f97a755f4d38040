// SPDX-License-Identifier: Apache-2.0
// A camera that looks around from one point.
#pragma once

#include <array>

namespace welkin::render {

struct Camera {
  double yaw_rad = 0.0;    ///< clockwise from north
  double pitch_rad = 0.0;  ///< above the horizon
  double fov_rad = 1.0;    ///< vertical, in (0, pi)
};

/// Returns a column-major matrix for WelkinVulkanView, from device coordinates (x right, y down, any depth) to a world
/// direction.
std::array<float, 16> inverseViewProjection(const Camera& camera, double aspect);

}  // namespace welkin::render
