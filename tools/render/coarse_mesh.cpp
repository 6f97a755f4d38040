// SPDX-License-Identifier: Apache-2.0
#include "render/coarse_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <map>

namespace welkin::render {
namespace {

constexpr std::size_t kShareOfLevel[kCoarseLevels] = {4, 16};
constexpr float kWorstError = 0.2F;  // of the mesh's size; a piece that needs more keeps more triangles

/// Appends a piece of a mesh with a share of its triangles.
CoarseDraw simplified(const level::Scene& scene, const level::Draw& draw, std::size_t share,
                      std::vector<uint32_t>& indices) {
  const uint32_t* from = scene.indices.data() + draw.first_index;
  const level::Vertex* vertices = scene.vertices.data() + draw.vertex_offset;
  const std::size_t vertex_count = *std::max_element(from, from + draw.index_count) + std::size_t{1};
  const std::size_t target = std::max<std::size_t>(draw.index_count / 3 / share, 2) * 3;
  std::vector<uint32_t> coarse(draw.index_count);
  float error = 0.0F;
  std::size_t count = meshopt_simplify(coarse.data(), from, draw.index_count, vertices->position, vertex_count,
                                       sizeof(level::Vertex), target, kWorstError, 0U, &error);
  if (count > target + target / 2)  // hard edges keep vertices apart, which this way ignores
    count = meshopt_simplifySloppy(coarse.data(), from, draw.index_count, vertices->position, vertex_count,
                                   sizeof(level::Vertex), target, kWorstError, &error);
  const float scale = meshopt_simplifyScale(vertices->position, vertex_count, sizeof(level::Vertex));
  const CoarseDraw result{static_cast<uint32_t>(indices.size()), static_cast<uint32_t>(count),
                          double{error} * double{scale}};
  indices.insert(indices.end(), coarse.begin(), coarse.begin() + static_cast<std::ptrdiff_t>(count));
  return result;
}

}  // namespace

CoarseMesh coarseMesh(const level::Scene& scene) {
  CoarseMesh mesh;
  std::map<std::pair<uint32_t, int32_t>, std::size_t> known;  // draws by first index and vertex offset
  for (const level::Draw& draw : scene.draws) {
    const auto [same, is_new] = known.emplace(std::pair(draw.first_index, draw.vertex_offset), mesh.draw.size());
    std::array<CoarseDraw, kCoarseLevels> levels{};
    if (!is_new)
      levels = mesh.draw[same->second];
    else if (draw.index_count > 0)
      for (std::size_t i = 0; i < kCoarseLevels; ++i)
        levels[i] = simplified(scene, draw, kShareOfLevel[i], mesh.indices);
    mesh.draw.push_back(levels);
  }
  return mesh;
}

}  // namespace welkin::render
