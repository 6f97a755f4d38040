// SPDX-License-Identifier: Apache-2.0
// What certificates compare at an instant: the irradiance of the model, and that of the runtime.
#pragma once

#include <welkin/welkin.h>

#include "sky/table/day_fields.h"

namespace welkin::bake {

using det::Number3;

/// Errors of an instant by channel, before the division.
struct InstantErrors {
  double error[3] = {};
  Number3 normal[3];
  double sum[3] = {};
  std::size_t normals = 0;

  void at(const Number3& direction, const Number3& got, const Number3& want);
};

/// A sky's model at an instant.
class ModelInstant {
 public:
  ModelInstant(const model::Sky& sky, const table::DayInstant& at);

  /// World direction of a normal in the sun's frame, on either side of the sun's plane.
  Number3 inWorld(const Number3& normal, double side) const;

  /// Irradiance with ground and after desaturation; `shape` is that of the sky at the normal, at intensity 1.
  Number3 irradiance(const Number3& normal, const Number3& shape) const;

  const model::SkyInstant& instant() const { return instant_; }

 private:
  const table::DayInstant& at_;
  model::SkyInstant instant_;
  Number3 along_, ground_;
};

/// The runtime's sample and irradiance. Throw Error(internal) where it refuses them.
WelkinSkySample sampleOf(const WelkinSky* opened, double time_h);
Number3 irradianceOf(const WelkinSky* opened, const WelkinSkySample& sample, const Number3& normal);

}  // namespace welkin::bake
