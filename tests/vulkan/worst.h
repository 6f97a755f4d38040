// SPDX-License-Identifier: Apache-2.0
// The largest error of a comparison and its place, and the tolerance for a device.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "render/vulkan_device.h"

namespace welkin::tests {

/// Relative tolerance of the dome. Its largest error is that of atan, which enters twice. One way is the angle to the
/// sun (twice an atan) and exp(d theta), d = -3. The other is the gradient's row: times rows / (pi / 2), at most 4, of
/// a texel difference of about 1. Vulkan ("Precision and Operation of SPIR-V Instructions") allows atan 4096 units in
/// the last place, 4.9e-4 of the angle, and cos 2^-11: 1e-3 + 2e-3. Mesa's atan, a polynomial, is off by up to 4e-6
/// rad: 2.4e-5 + 1e-5. The software rasteriser is held to that, so that a slip in a formula cannot hide behind the
/// specification.
inline double shaderTolerance(const render::VulkanDevice& device) {
  return device.properties().deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 4e-5 : 4e-3;
}

struct Worst {
  double error = 0.0;
  std::string where;
  std::size_t count = 0;

  /// Adds a difference relative to `scale`. NaN counts as infinite.
  template <typename Where>
  void compare(double value, double expected, double scale, Where&& describe) {
    ++count;
    double e = std::abs(value - expected) / scale;
    if (!(e < 1e30)) e = value == expected ? 0.0 : 1e30;
    if (e <= error) return;
    error = e;
    char text[64];
    std::snprintf(text, sizeof(text), ": %.9g for %.9g", value, expected);
    where = describe() + text;
  }
};

}  // namespace welkin::tests
