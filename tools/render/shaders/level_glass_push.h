// SPDX-License-Identifier: Apache-2.0
// Push constants of a draw of glass; C++ and GLSL.
#ifndef WELKIN_LEVEL_GLASS_PUSH_H
#define WELKIN_LEVEL_GLASS_PUSH_H

#ifdef __cplusplus
namespace welkin::render::shaders {
struct GlassPush {
  float alpha;         // share of the surface that is there
  float transmission;  // share of light that passes what is there, times the albedo
};
static_assert(sizeof(GlassPush) == 8);
}  // namespace welkin::render::shaders
#else
layout(push_constant) uniform GlassPush {
  float alpha;
  float transmission;
}
push;
#endif

#endif
