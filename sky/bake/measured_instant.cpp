// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/measured_instant.h"

#include <cmath>

#include "sky/base/error.h"

namespace welkin::bake {

void InstantErrors::at(const Number3& direction, const Number3& got, const Number3& want) {
  ++normals;
  for (int c = 0; c < 3; ++c) {
    const double off = std::abs(got[c] - want[c]);
    sum[c] += off;
    if (off <= error[c]) continue;
    error[c] = off;
    normal[c] = direction;
  }
}

ModelInstant::ModelInstant(const model::Sky& sky, const table::DayInstant& at) : at_(at), instant_(sky, at.time_h) {
  const Number3& sun = instant_.sunDirection();
  const double length = det::horizontalLength(sun);
  along_ = length > 0.0 ? Number3(sun.x / length, 0.0, sun.z / length) : Number3(0.0, 0.0, 1.0);
  ground_ = instant_.groundRadiance(at.field.moments.horizontal_irradiance);
}

Number3 ModelInstant::inWorld(const Number3& n, double side) const {
  return along_ * n.z + Number3(along_.z, 0.0, -along_.x) * (side * n.x) + Number3(0.0, n.y, 0.0);
}

Number3 ModelInstant::irradiance(const Number3& normal, const Number3& shape) const {
  return det::desaturate(shape * at_.intensity + ground_ * det::groundIrradiance(normal.y), at_.saturation);
}

WelkinSkySample sampleOf(const WelkinSky* opened, double time_h) {
  WelkinSkySample sample{};
  if (welkin_sky_sample(opened, time_h, &sample) != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal, "the certificate: the runtime cannot sample the baked sky");
  return sample;
}

Number3 irradianceOf(const WelkinSky* opened, const WelkinSkySample& sample, const Number3& normal) {
  const float n[3] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
  float e[3];
  if (welkin_sky_irradiance(opened, &sample, n, e) != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal, "the certificate: the runtime gives no irradiance");
  return {double{e[0]}, double{e[1]}, double{e[2]}};
}

}  // namespace welkin::bake
