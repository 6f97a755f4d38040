// SPDX-License-Identifier: Apache-2.0
// Places a level's surfaces.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_instances.glsl"
#include "welkin/contact.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 0) out vec3 placed_normal;
layout(location = 1) out vec4 albedo;  // alpha: metallic
layout(location = 2) out float height;
layout(location = 3) flat out vec3 emission;
layout(location = 4) out vec2 contact;  // contact factor, gloss

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_CONTACT, std430) readonly buffer LevelContact {
  uint contactWords[];
};

float contactOf(int first) {
  if (level.picture.y == 0.0 || first < -(1 << 30)) return 1.0;
  uint i = uint(first + gl_VertexIndex);
  return welkinContactFactor(float((contactWords[i / 4u] >> (8u * (i % 4u))) & 255u) / 255.0);
}

void main() {
  LevelInstance i = instances[gl_InstanceIndex];
  vec3 p = placedPoint(i, position);
  placed_normal = normalize(placedNormal(i, normal));
  albedo = vec4(colour * i.albedo.rgb, i.albedo.a);
  height = p.y;
  emission = i.emission;
  contact = vec2(contactOf(i.contact), i.gloss.x);
  gl_Position = level.view_projection * vec4(p, 1.0);
}
