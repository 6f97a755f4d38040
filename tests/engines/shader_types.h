// SPDX-License-Identifier: Apache-2.0
// The vectors and functions of GLSL and HLSL that the shader code of docs/engines.md uses.
#pragma once

#include <algorithm>

namespace welkin::tests::shader {

struct vec3 {
  float x, y, z;
  vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
  explicit vec3(double all) : x(static_cast<float>(all)), y(x), z(x) {}
};

struct vec4 {
  float x = 0.0F, y = 0.0F, z = 0.0F, w = 0.0F;
  vec4() = default;
  vec4(float x_, float y_, float z_, double w_) : x(x_), y(y_), z(z_), w(static_cast<float>(w_)) {}
  explicit vec4(const float* v) : x(v[0]), y(v[1]), z(v[2]), w(v[3]) {}
};

inline float dot(const vec4& a, const vec4& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

inline vec3 operator+(const vec3& a, const vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline vec3 operator*(const vec3& a, float b) {
  return {a.x * b, a.y * b, a.z * b};
}

inline vec3 max(const vec3& a, const vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

using float3 = vec3;
using float4 = vec4;

}  // namespace welkin::tests::shader
