// SPDX-License-Identifier: Apache-2.0
// Push constants and the scene of the sphere picture; C++ and GLSL.
#ifndef WELKIN_SPHERES_PUSH_H
#define WELKIN_SPHERES_PUSH_H

#ifdef __cplusplus
#include <cstdint>
namespace welkin::tools {
struct SpheresPush {
  float inverse_view_projection[16];
  float aspect;
  uint32_t light;  // WELKIN_LIGHT_...
  uint32_t from_cubemaps;
};
static_assert(sizeof(SpheresPush) == 76);
}  // namespace welkin::tools
#else
layout(push_constant) uniform SpheresPush {
  mat4 inverse_view_projection;
  float aspect;
  uint light;
  uint from_cubemaps;
}
push;
#endif

#define WELKIN_LIGHT_FLAT 0
#define WELKIN_LIGHT_SH 1
#define WELKIN_LIGHT_BOTH 2  // flat on the left half of the row, SH on the right

#define WELKIN_SPHERE_COUNT 6
#define WELKIN_SPHERE_RADIUS 0.42  // of the distance between centres; of the picture's height where that is less
// Albedo by the distance from the middle of the row: 0.2 in the middle, 0.8 at the ends.
#define WELKIN_SPHERE_ALBEDO(from_middle) (0.2 + 0.3 * (from_middle))

#endif
