// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that reads the far map.
#include <algorithm>
#include <cmath>

#include "core/floats.h"
#include "probes/volume.h"
#include "shared.h"

#define INLINE inline
#define NUMBER(literal) Number(literal)
namespace welkin::probes::far_formulas {
using namespace f64;
#include "far.glsl"  // NOLINT(bugprone-suspicious-include)
}  // namespace welkin::probes::far_formulas
#undef NUMBER
#undef INLINE

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_volume_far_map(const WelkinVolume* volume, const void** texels, uint32_t* edge) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"texels", texels}, {"edge", edge}})) return r;
  *texels = volume->far_map.texels();
  *edge = volume->far_map.edge();
  return WELKIN_OK;
}

WelkinResult welkin_volume_far_visibility(const WelkinVolume* volume, const float position[3], const float* normal,
                                          float* visibility) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"position", position}, {"visibility", visibility}}))
    return r;
  if (normal != nullptr)
    if (const auto r = unit(__func__, "normal", normal)) return r;
  const FarMap& map = volume->far_map;
  double inside = map.reach_m(), place[3];
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(std::abs(position[a]) <= 1e7F))
      return refuse(__func__, "position[%zu] is %g, must be within 1e7 m", a, double{position[a]});
    place[a] = double{position[a]} + (normal == nullptr ? 0.0 : kPush_m * double{normal[a]});
    if (a != 1) inside = std::min(inside, map.reach_m() - std::abs(double{position[a]} - volume->camera[a]));
  }
  const auto texel = map.at(place[0], place[2]);
  const double share = std::clamp(inside / map.border_m(), 0.0, 1.0);
  *visibility = toFloat(far_formulas::farVisibility(texel[0], texel[1], double{position[1]}, map.fade_m(), share));
  return WELKIN_OK;
}
