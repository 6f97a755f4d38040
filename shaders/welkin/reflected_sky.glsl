// SPDX-License-Identifier: Apache-2.0
// The sky as rough surfaces reflect it, from the chain that welkin_vulkan_reflection.h filters. Sun, moon and stars are
// left out: the highlight of the key light is specular.glsl's.
// Needs: #extension GL_GOOGLE_include_directive : require, WELKIN_REFLECTION_SET.
#ifndef WELKIN_REFLECTED_SKY_GLSL
#define WELKIN_REFLECTED_SKY_GLSL

#ifndef WELKIN_REFLECTION_SET
#error WELKIN_REFLECTION_SET is not defined: the number of the descriptor set of welkin_vulkan_reflection.h
#endif

#include "materials.glsl"

layout(set = WELKIN_REFLECTION_SET, binding = 0) uniform samplerCube welkinReflectedChain;

// Mean radiance of the open sky over the lobe of `gloss` in [0, 1] about `direction`, the mirrored view, unit, in world
// axes.
vec3 welkinReflectedSky(vec3 direction, float gloss) {
  float mips = float(textureQueryLevels(welkinReflectedChain));
  return textureLod(welkinReflectedChain, direction, mipOfGloss(gloss, mips)).rgb;
}

// The light of the sky that a surface reflects towards the viewer. `c` is its specular colour and `power` that of
// gloss.glsl; n and v are unit vectors away from the surface. The diffuse part keeps 1 - reflectedShare(c, power, n.v).
// `open` is the share of the sky that is not hidden, openShare() or 1.
vec3 welkinReflection(vec3 c, float power, vec3 n, vec3 v, vec3 open) {
  float n_dot_v = clamp(dot(n, v), 0.0, 1.0);
  return welkinReflectedSky(reflect(-v, n), glossOfPower(power)) * reflectedShare(c, power, n_dot_v) * open;
}

#endif
