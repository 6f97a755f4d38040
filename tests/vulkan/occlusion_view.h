// SPDX-License-Identifier: Apache-2.0
// A G-buffer of a level, found by rays, as shaders/occlusion.comp reads it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "probes/geometry/tracer.h"
#include "render/camera.h"

namespace welkin::tests {

struct OcclusionView {
  uint32_t width, height;
  std::vector<float> buffer;
  std::vector<std::pair<std::size_t, geometry::Hit>> seen;  ///< pixels, row by row, and their surfaces

  std::size_t pixels() const { return std::size_t{width} * height; }
  /// Sets the visibility that the denoising reads.
  void setFound(const std::vector<float>& visibility);
};

OcclusionView occlusionView(const geometry::Tracer& tracer, const render::Camera& camera, const geometry::Number3& eye,
                            uint32_t width, uint32_t height);

}  // namespace welkin::tests
