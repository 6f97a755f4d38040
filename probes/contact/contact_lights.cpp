// SPDX-License-Identifier: Apache-2.0
#include "probes/contact/contact_lights.h"

#include <algorithm>

#include "sky/model/projection.h"

namespace welkin::contact {
namespace {

constexpr std::size_t kEvenSkies = 2;  ///< TrainingSkies begins with them
constexpr std::size_t kSuns = 6;

/// Up to `most` times of day at which a light stands above the horizon, evenly spread.
std::vector<double> timesOf(const model::Light& light, std::size_t most) {
  constexpr double kLow_y = 0.02;  // as TrainingSkies has it
  constexpr int kSteps = 96;
  std::vector<double> up;
  for (int i = 0; i < kSteps; ++i)
    if (light.path.directionAt(24.0 * i / kSteps).y > kLow_y) up.push_back(24.0 * i / kSteps);
  std::vector<double> times;
  const std::size_t count = std::min(most, up.size());
  for (std::size_t i = 0; i < count; ++i) times.push_back(up[(2 * i + 1) * up.size() / (2 * count)]);
  return times;
}

std::vector<Number3> directionsOf(const model::Light& light, const std::vector<double>& times) {
  std::vector<Number3> directions;
  for (const double time_h : times) directions.push_back(light.path.directionAt(time_h));
  return directions;
}

double horizontalOf(const model::Sky& sky, double time_h) {
  const model::SkyInstant instant(sky, time_h);
  const model::SkyProjector projector(sky.luminance, 2, 1e-6);
  return det::luminanceOf(projector.irradiance(instant, {0, 1, 0}) * instant.intensity());
}

}  // namespace

ContactLights::ContactLights(const model::Sky& sky) : skies_(directionsOf(sky.sun, timesOf(sky.sun, kSuns))) {
  for (std::size_t l = 0; l < kEvenSkies; ++l) light_.push_back({l, {}, 0.0, 0.0});
  const std::vector<double> times = timesOf(sky.sun, kSuns);
  direction_ = directionsOf(sky.sun, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double unit = horizontalOf(sky, times[i]);
    if (!(unit > 0.0)) continue;
    const double irradiance = det::luminanceOf(sky.sun.normalIrradianceAt(times[i])) / unit;
    light_.push_back({kEvenSkies + i, i, irradiance, times[i]});
  }
}

std::vector<sectors::LevelLight> ContactLights::on(const std::vector<sectors::SectorFile>& sectors) const {
  std::vector<sectors::LevelLight> probes;
  for (const ContactLight& l : light_) {
    sectors::LightOfDay light;
    for (std::size_t k = 0; k < light.sky_sh.size(); ++k) light.sky_sh[k] = Number3(skies_.coefficient(l.sky)[k]);
    if (l.sun) light.sun = {direction_[*l.sun], Number3(l.irradiance)};
    probes.emplace_back(sectors, light, l.time_h);
  }
  return probes;
}

}  // namespace welkin::contact
