// SPDX-License-Identifier: Apache-2.0
// Push constants and groups of the pass that filters the sky for rough surfaces; C++ and GLSL.
#ifndef WELKIN_REFLECTION_FILTER_H
#define WELKIN_REFLECTION_FILTER_H

#define WELKIN_REFLECTION_LANES 16  // invocations that share a texel
#define WELKIN_REFLECTION_GROUP 4   // texels of a group

#ifdef __cplusplus
#include <cstdint>
namespace welkin::passes {
struct ReflectionPush {
  int32_t edge;  // of the mip, texels
  int32_t face;  // the first one
  float power;   // of the lobe
};
static_assert(sizeof(ReflectionPush) == 12);
}  // namespace welkin::passes
#else
layout(push_constant) uniform ReflectionPush {
  int edge;
  int face;
  float power;
}
push;
#endif

#endif
