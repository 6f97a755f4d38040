// SPDX-License-Identifier: Apache-2.0
// Definitions that let the *.glsl files of this folder compile as C++: a three-component vector and GLSL's functions on
// it. Scalar functions (exp, sin, ...) come from the namespace that includes the formulas; see shared.h.
#pragma once

namespace welkin {

/// GLSL's vec3 for a scalar type T. Plain data. A direction has x east, y up, z south.
template <typename T>
struct Vector3 {
  T x{}, y{}, z{};

  constexpr Vector3() = default;
  constexpr explicit Vector3(T all) : x(all), y(all), z(all) {}
  constexpr Vector3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  template <typename U>
  constexpr explicit Vector3(const Vector3<U>& v)
      : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z)) {}

  constexpr T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr const T& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr Vector3& operator+=(const Vector3& v) { return *this = *this + v; }
  constexpr Vector3& operator*=(T s) { return *this = *this * s; }

  friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector3 operator*(const Vector3& a, const Vector3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr Vector3 operator*(const Vector3& a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vector3 operator*(T s, const Vector3& a) { return a * s; }
  friend constexpr Vector3 operator/(const Vector3& a, T s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr bool operator==(const Vector3& a, const Vector3& b) = default;
};

template <typename T>
constexpr T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename T>
constexpr Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename T>
constexpr T min(T a, T b) {
  return b < a ? b : a;
}

template <typename T>
constexpr T max(T a, T b) {
  return a < b ? b : a;
}

template <typename T>
constexpr T clamp(T x, T low, T high) {
  return min(max(x, low), high);
}

template <typename T>
constexpr Vector3<T> mix(const Vector3<T>& a, const Vector3<T>& b, T t) {
  return a * (T(1) - t) + b * t;
}

}  // namespace welkin
