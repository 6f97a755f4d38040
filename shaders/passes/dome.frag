// SPDX-License-Identifier: Apache-2.0
// The sky dome from the formulas or the cubemaps: radiance, alpha 1. Outside the fisheye's circle all components are 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#include "../welkin/sky_bindings.h"
#include "../welkin/discs.glsl"
#include "../welkin/dome.glsl"
#include "../welkin/stars.glsl"
#include "../welkin/view.glsl"
#include "dome_push.h"

layout(constant_id = 0) const bool kFromCubemaps = false;

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 radiance;

// No branch depends on uniforms alone, because lavapipe recompiles a shader at every draw for such a branch.
void main() {
  bool fisheye = (push.flags & WELKIN_DOME_FISHEYE) != 0;
  vec2 p = ndc * push.fisheye_scale;
  vec3 direction = mix(welkinPerspectiveDirection(push.inverse_view_projection, ndc), welkinFisheyeDirection(p), bvec3(fisheye));
  float pixel_rad = max(length(dFdx(direction)), length(dFdy(direction)));
  float shown = float(!fisheye || dot(p, p) <= 1.0);
  float discs = float((push.flags & WELKIN_DOME_DISCS) != 0);
  vec3 sky = kFromCubemaps ? welkinDomeFromCubemaps(direction) : welkinDomeRadiance(direction);
  radiance = vec4(sky + discs * (welkinDiscs(direction, pixel_rad) + welkinStars(direction, sky)), 1.0) * shown;
}
