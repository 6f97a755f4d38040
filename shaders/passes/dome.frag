// SPDX-License-Identifier: Apache-2.0
// The sky dome, from the formulas or from the cubemaps; radiance, alpha 1. Outside the fisheye's circle all is 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#include "../welkin/sky_bindings.h"
#include "../welkin/discs.glsl"
#include "../welkin/dome.glsl"
#include "../welkin/view.glsl"
#include "dome_push.h"

layout(constant_id = 0) const bool kFromCubemaps = false;

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 radiance;

void main() {
  bool fisheye = (push.flags & WELKIN_DOME_FISHEYE) != 0;
  vec2 p = ndc * push.fisheye_scale;
  vec3 direction = fisheye ? welkinFisheyeDirection(p) : welkinPerspectiveDirection(push.inverse_view_projection, ndc);
  float pixel_rad = max(length(dFdx(direction)), length(dFdy(direction)));
  if (fisheye && dot(p, p) > 1.0) {
    radiance = vec4(0.0);
    return;
  }
  vec3 sky = kFromCubemaps ? welkinDomeFromCubemaps(direction) : welkinDomeRadiance(direction);
  if ((push.flags & WELKIN_DOME_DISCS) != 0) sky += welkinDiscs(direction, pixel_rad);
  radiance = vec4(sky, 1.0);
}
