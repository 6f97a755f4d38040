// SPDX-License-Identifier: Apache-2.0
// A row of diffuse spheres in front of the sky, in parallel projection, lit by the sky's ambient light alone. There are
// no shadows, no bounce between the spheres and no direct sun.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#include "welkin/sky_bindings.h"
#include "sky_light.glsl"
#include "welkin/discs.glsl"
#include "welkin/dome.glsl"
#include "welkin/view.glsl"
#include "spheres_push.h"

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 radiance;

void main() {
  mat4 view = push.inverse_view_projection;
  vec3 direction = welkinPerspectiveDirection(view, ndc);
  float pixel_rad = max(length(dFdx(direction)), length(dFdy(direction)));
  vec3 colour = push.from_cubemaps != 0 ? welkinDomeFromCubemaps(direction) : welkinDomeRadiance(direction);
  colour += welkinDiscs(direction, pixel_rad);

  float spacing = 2.0 * push.aspect / float(WELKIN_SPHERE_COUNT);
  float radius = WELKIN_SPHERE_RADIUS * min(spacing, 2.0);
  float across = (ndc.x * push.aspect) / spacing + 0.5 * float(WELKIN_SPHERE_COUNT);
  int column = clamp(int(floor(across)), 0, WELKIN_SPHERE_COUNT - 1);
  vec2 p = vec2((across - float(column) - 0.5) * spacing, ndc.y) / radius;
  float edge = length(vec2(dFdx(ndc.x) * push.aspect, dFdy(ndc.y))) * 0.7071 / radius;
  float coverage = clamp((1.0 - length(p)) / edge + 0.5, 0.0, 1.0);
  if (coverage > 0.0) {
    p /= max(length(p), 1.0);
    vec3 right = normalize(view[0].xyz);
    vec3 down = normalize(view[1].xyz);
    vec3 normal = normalize(right * p.x + down * p.y - view[3].xyz * sqrt(max(1.0 - dot(p, p), 0.0)));
    bool flat_light = push.light == WELKIN_LIGHT_FLAT || (push.light == WELKIN_LIGHT_BOTH && column < WELKIN_SPHERE_COUNT / 2);
    vec3 irradiance = flat_light ? welkinFlatIrradiance() : skyIrradiance(normal);
    colour = mix(colour, WELKIN_SPHERE_ALBEDO / kPi * irradiance, coverage);
  }
  radiance = vec4(colour, 1.0);
}
