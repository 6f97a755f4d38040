// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/cut_candidates.h"

#include <algorithm>
#include <cmath>

namespace welkin::placement {
namespace {

constexpr std::size_t kMostPlanes = 40;  // candidates of a cell
constexpr double kThickest_m = 0.8;      // of a wall whose middle is a candidate

}  // namespace

std::vector<CutCandidate> candidatePlanes(const std::vector<CellFace>& faces) {
  struct Flat {
    format::CutPlane plane;
    double area_m2;
    bool up;  ///< it looks along the plane's normal
  };
  constexpr int kSameNormal = 40;  // steps of 1/32767
  const auto isAlong = [](const format::CutPlane& a, const format::CutPlane& b) {
    return std::abs(a.u() - b.u()) <= kSameNormal && std::abs(a.v() - b.v()) <= kSameNormal;
  };
  std::vector<Flat> flat;
  for (const CellFace& face : faces) {
    if (face.corner.empty()) continue;
    const format::FromCorner n = format::normalOf(face.plane);
    const bool up = double{n[0]} * face.normal.x + double{n[1]} * face.normal.y + double{n[2]} * face.normal.z > 0.0;
    const auto same = std::find_if(flat.begin(), flat.end(), [&](const Flat& f) {
      constexpr float kSameOffset_m = 2e-3F;
      return f.up == up && isAlong(f.plane, face.plane) &&
             std::abs(f.plane.offset() - face.plane.offset()) < kSameOffset_m;
    });
    if (same != flat.end())
      same->area_m2 += face.area_m2;
    else
      flat.push_back({face.plane, face.area_m2, up});
  }
  std::stable_sort(flat.begin(), flat.end(), [](const Flat& a, const Flat& b) { return a.area_m2 > b.area_m2; });
  flat.resize(std::min(flat.size(), kMostPlanes));
  std::vector<CutCandidate> planes;
  for (std::size_t a = 0; a < flat.size(); ++a)
    for (std::size_t b = a + 1; b < flat.size(); ++b) {
      const float apart = std::abs(flat[a].plane.offset() - flat[b].plane.offset());
      const Flat& high = flat[a].plane.offset() > flat[b].plane.offset() ? flat[a] : flat[b];
      const Flat& low = &high == &flat[a] ? flat[b] : flat[a];
      const bool is_wall = high.up && !low.up && double{apart} <= kThickest_m;  // its faces look away from each other
      if (!is_wall || !isAlong(high.plane, low.plane)) continue;
      const format::CutPlane& p = flat[a].plane;
      planes.push_back({{p.u(), p.v(), 0.5F * (p.offset() + flat[b].plane.offset())}, true});
    }
  planes.resize(std::min(planes.size(), kMostPlanes));
  for (const Flat& f : flat) planes.push_back({f.plane, false});
  return planes;
}

}  // namespace welkin::placement
