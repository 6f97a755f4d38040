// SPDX-License-Identifier: Apache-2.0
// Fewer triangles for what is far away: each draw of a scene, simplified to a quarter and to a sixteenth.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "probes/level/scene.h"

namespace welkin::render {

/// Indices of a simplified draw, with the draw's own vertices.
struct CoarseDraw {
  uint32_t first_index = 0, index_count = 0;
  double error_m = 0.0;  ///< distance from the draw's surface, about; of a mesh that is placed without scale
};

inline constexpr std::size_t kCoarseLevels = 2;

struct CoarseMesh {
  std::vector<uint32_t> indices;                            ///< of all levels
  std::vector<std::array<CoarseDraw, kCoarseLevels>> draw;  ///< by draw of the scene, from finer to coarser
};

/// By meshoptimizer. Draws of the same piece of a mesh share their indices.
CoarseMesh coarseMesh(const level::Scene& scene);

}  // namespace welkin::render
