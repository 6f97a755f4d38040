// SPDX-License-Identifier: Apache-2.0
// The G-buffer of 64 x 32 pixels, and the light of the ambient pass.
struct Pixel {
  vec4 position;  // w: 1, or 0 without a surface
  vec4 normal, irradiance;
};
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 2, binding = 0, std430) buffer GBuffer {
  Pixel pixel[];
};
layout(push_constant) uniform View {
  vec4 camera;  // metres; w is unused
};

uint pixelIndex() {
  return gl_GlobalInvocationID.x + 64 * gl_GlobalInvocationID.y;
}
