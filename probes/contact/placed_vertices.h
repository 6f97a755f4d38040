// SPDX-License-Identifier: Apache-2.0
// The vertices of a level's static geometry as a game draws them: one for each vertex of each placed piece of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "probes/level/scene.h"

namespace welkin::contact {

using f64::Number3;

/// Placed pieces in the order of Scene::instances, and their vertices in the order of the piece.
struct PlacedVertices {
  struct Piece {
    std::uint32_t instance = 0;  ///< index into Scene::instances
    std::uint32_t first = 0;     ///< of its vertices
    std::uint32_t count = 0;
  };
  std::vector<Piece> piece;
  std::vector<Number3> position;                       ///< metres, world
  std::vector<Number3> normal;                         ///< unit, world
  std::vector<std::array<std::uint32_t, 3>> triangle;  ///< with an area; counter-clockwise from its front

  /// Of every vertex, a number that vertices of the same place and normal share. Numbers ascend from 0.
  std::vector<std::uint32_t> shared;
  std::size_t places = 0;  ///< of such numbers
};

/// Pieces of role Role::fixed. Throws Error(content) where there are more than 2^32 vertices.
PlacedVertices placedVertices(const level::Scene& scene);

}  // namespace welkin::contact
