// SPDX-License-Identifier: Apache-2.0
// Stand-ins for the types of Unreal that the C++ of docs/engines.md uses: names, signatures and results as its API
// reference documents them. Colours of lights have 8 bits there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

namespace welkin::tests::unreal_stub {

using TCHAR = char;
using int32 = std::int32_t;
#define TEXT(text) text

struct FName {
  std::string text;
  FName(const TCHAR* name) : text(name) {}  // Unreal's is implicit too.
};

class FString {
 public:
  template <typename... T>
  static FString Printf(const TCHAR* format, T... values) {
    char text[64];
    std::snprintf(text, sizeof text, format, values...);
    FString result;
    result.text_ = text;
    return result;
  }
  const TCHAR* operator*() const { return text_.c_str(); }

 private:
  std::string text_;
};

struct FMath {
  static float Max(float a, float b) { return std::max(a, b); }
};

/// Degrees. The forward vector of yaw 0 and pitch 0 is +x.
struct FRotator {
  double Pitch, Yaw, Roll;
};

struct FVector {
  double X, Y, Z;
  FVector(double x, double y, double z) : X(x), Y(y), Z(z) {}
  FVector operator-() const { return {-X, -Y, -Z}; }
  FRotator Rotation() const {
    constexpr double kDegrees = 57.29577951308232;
    return {std::atan2(Z, std::sqrt(X * X + Y * Y)) * kDegrees, std::atan2(Y, X) * kDegrees, 0.0};
  }
};

struct FLinearColor {
  float R, G, B, A;
  FLinearColor(float r, float g, float b, float a = 1.0F) : R(r), G(g), B(b), A(a) {}
  float GetMax() const { return std::max(std::max(std::max(R, G), B), A); }
  FLinearColor operator/(float scalar) const { return {R / scalar, G / scalar, B / scalar, A / scalar}; }
};

struct UWorld {};

struct UMaterialParameterCollection {
  std::map<std::string, FLinearColor> vectors;
};

struct UKismetMaterialLibrary {
  static void SetVectorParameterValue(UWorld*, UMaterialParameterCollection* collection, FName name,
                                      const FLinearColor& value) {
    collection->vectors.insert_or_assign(name.text, value);
  }
};

struct UDirectionalLightComponent {
  FRotator rotation{};
  float colour[3] = {};  ///< linear, as it is read back from 8 bits
  float intensity = 0.0F;

  void SetWorldRotation(const FRotator& value) { rotation = value; }
  void SetIntensity(float value) { intensity = value; }
  void SetLightColor(const FLinearColor& value, bool srgb) {
    const float linear[3] = {value.R, value.G, value.B};
    for (int c = 0; c < 3; ++c) {
      const float v = std::clamp(linear[c], 0.0F, 1.0F);
      const float encoded = !srgb ? v : v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
      const float byte = std::round(encoded * 255.0F) / 255.0F;
      colour[c] = byte <= 0.04045F ? byte / 12.92F : std::pow((byte + 0.055F) / 1.055F, 2.4F);
    }
  }
};

}  // namespace welkin::tests::unreal_stub
