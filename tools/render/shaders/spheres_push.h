// SPDX-License-Identifier: Apache-2.0
// Push constants and the scene of the sphere picture; C++ and GLSL.
#ifndef WELKIN_SPHERES_PUSH_H
#define WELKIN_SPHERES_PUSH_H

#ifdef __cplusplus
#include <cstdint>
namespace welkin::render::shaders {
struct SpheresPush {
  float inverse_view_projection[16];
  float aspect;
  uint32_t light;  // WELKIN_LIGHT_...
  uint32_t from_cubemaps;
};
static_assert(sizeof(SpheresPush) == 76);
}  // namespace welkin::render::shaders
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
#define WELKIN_LIGHT_BOTH 2  // flat on the left sphere, by direction on the right

#define WELKIN_SPHERE_COUNT 2
#define WELKIN_SPHERE_RADIUS 0.4  // share of the distance between centres, or of the picture's height if that is less
#define WELKIN_SPHERE_ALBEDO 0.8  // a light probe, as in the notes' figures 10 and 11

#endif
