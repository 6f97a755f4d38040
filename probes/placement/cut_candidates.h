// SPDX-License-Identifier: Apache-2.0
// The planes that may part a cell.
#pragma once

#include "probes/placement/cell_faces.h"

namespace welkin::placement {

/// A plane that may part a cell.
struct CutCandidate {
  format::CutPlane plane;
  bool middle = false;  ///< in the middle of a thin wall, so that rounding never takes a point across
};

/// The middles of thin walls, and the planes of a cell's faces, the largest first.
std::vector<CutCandidate> candidatePlanes(const std::vector<CellFace>& faces);

}  // namespace welkin::placement
