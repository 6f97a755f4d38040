// SPDX-License-Identifier: Apache-2.0
// Light that a material of glTF reflects: a diffuse part, and the sky and the sun or the moon in its gloss.
#ifndef WELKIN_LEVEL_GLOSSY_GLSL
#define WELKIN_LEVEL_GLOSSY_GLSL

#include "level_view.glsl"
#ifdef WELKIN_LIGHT_OF_PROBES
#define WELKIN_REFLECTION_SET 3
#else
#define WELKIN_REFLECTION_SET 2
#endif
#include "welkin/reflected_sky.glsl"

// Share of the sky's reflection along a direction that is left at a surface: by the probes' light from there. Without
// probes nothing says what hides it.
#ifdef WELKIN_LIGHT_OF_PROBES
vec3 skyShare(vec3 p, vec3 n, vec3 direction) {
  vec3 open = skyIrradiance(direction) * level.picture.z;  // as the probes' light has it
  vec3 beyond = open * welkinFarVisibility(p, n);
  return openShare(mix(beyond, welkinVolumeIrradianceTowards(p, n, direction), welkinVolumeWeight(p)), open);
}
#else
vec3 skyShare(vec3 p, vec3 n, vec3 direction) { return vec3(1.0); }
#endif

// Radiance towards the camera, without emission. `base` is the base colour and metallic, `irradiance` all that the
// diffuse part gets, and `visibility` a factor on the sky's reflection, at most 1 of it. What the gloss reflects of an
// even light the diffuse part loses.
vec3 glossyRadiance(vec3 p, vec3 n, vec4 base, float gloss, vec3 irradiance, float visibility) {
  vec3 v = normalize(level.camera.xyz - p);
  float power = powerOfGloss(gloss);
  vec3 c = specularColourOf(base.rgb, base.a);
  vec3 share = reflectedShare(c, power, clamp(dot(n, v), 0.0, 1.0));
  vec3 diffuse = diffuseColourOf(base.rgb, base.a) * (1.0 - share) / kPi * irradiance;
  vec3 open = skyShare(p, n, reflect(-v, n)) * (min(visibility, 1.0) * level.picture.z);
  vec3 sky = welkinReflection(c, power, n, v, open);
  float cosine = max(dot(n, level.light.xyz), 0.0);
  vec3 sun = schlickSmithSpecular(c, power, n, level.light.xyz, v) * level.light_irradiance.rgb * (cosine * lightReaching(p, n));
  return diffuse + sky + sun;
}

#endif
