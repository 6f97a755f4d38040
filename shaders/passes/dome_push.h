// SPDX-License-Identifier: Apache-2.0
// Push constants of the dome pass; C++ and GLSL.
#ifndef WELKIN_DOME_PUSH_H
#define WELKIN_DOME_PUSH_H

#ifdef __cplusplus
#include <cstdint>
namespace welkin::passes {
struct DomePush {
  float inverse_view_projection[16];  // column-major
  float fisheye_scale[2];             // normalised device coordinates to the unit disc of the fisheye
  float depth;                        // of the triangle, in [0, 1]
  uint32_t flags;
};
static_assert(sizeof(DomePush) == 80);
}  // namespace welkin::passes
#else
layout(push_constant) uniform DomePush {
  mat4 inverse_view_projection;
  vec2 fisheye_scale;
  float depth;
  uint flags;
}
push;
#endif

#define WELKIN_DOME_FISHEYE 1  // else perspective
#define WELKIN_DOME_DISCS 2    // draw the sun and the moon

#endif
