// SPDX-License-Identifier: Apache-2.0
#include "maps/prefiltered.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sh/spiral.h"
#include "sky/reflection/lobe_reference.h"
#include "sky/reflection/prefilter.h"

namespace welkin::maps {
namespace {

constexpr int kErrorAxes = 16;
constexpr reflection::LobeNodes kErrorNodes{12, 16};

double largestOf(const Number3& colour) {
  return std::max({colour.x, colour.y, colour.z});
}

/// Largest component of the mean radiance over the sphere.
double brightnessOf(const reflection::CubePyramid& pyramid) {
  const reflection::CubeLevel& level = pyramid.levels().back();
  Number3 mean(0.0);
  for (std::size_t i = 0; i < level.rgb.size(); ++i)
    mean[static_cast<int>(i % 3)] += double{level.rgb[i]} * level.solid_angle[i / 3 % level.solid_angle.size()];
  return largestOf(mean) / (2.0 * det::kTwoPi);
}

double errorOf(const reflection::Prefilter& filter, const reflection::Radiance& radiance, double power,
               double brightness) {
  std::array<double, kErrorAxes> error{};
  tbb::parallel_for(0, kErrorAxes, [&](int i) {
    const Number3 axis = sh::onSpiral(1.0 - (2 * i + 1.0) / kErrorAxes, i);
    const Number3 value = filter.at(axis);
    const Number3 truth = reflection::lobeReference(radiance, power, axis, kErrorNodes);
    double difference = 0.0;
    for (int c = 0; c < 3; ++c) difference = std::max(difference, std::abs(value[c] - truth[c]));
    if (difference > 0.0)
      error[static_cast<std::size_t>(i)] = difference / std::max({largestOf(truth), brightness, 1e-30});
  });
  return *std::max_element(error.begin(), error.end());
}

}  // namespace

std::vector<PrefilteredMip> prefilter(const WelkinSky* sky, const WelkinSkySample& sample,
                                      const Orientation& orientation, Projection projection, int size) {
  const Light radiance = domeOf(sky, sample);
  const reflection::CubePyramid pyramid(reflection::kSourceSize, radiance);
  const double brightness = brightnessOf(pyramid);
  std::vector<PrefilteredMip> mips(static_cast<std::size_t>(reflection::mipsOfSize(size)));
  for (std::size_t k = 0; k < mips.size(); ++k, size /= 2) {
    PrefilteredMip& mip = mips[k];
    mip.gloss = reflection::glossOfMip(static_cast<int>(k), static_cast<int>(mips.size()));
    mip.power = det::powerOfGloss(mip.gloss);
    const reflection::Prefilter filter(pyramid, mip.power);
    const auto light = [&](const Number3& axis) { return filter.at(axis); };
    mip.map =
        projection == Projection::cube ? cubeOf(light, orientation, size) : latlongOf(light, orientation, 2 * size);
    mip.error = errorOf(filter, radiance, mip.power, brightness);
  }
  return mips;
}

std::string prefilterJson(const std::vector<PrefilteredMip>& mips, double time_h) {
  nlohmann::ordered_json list = nlohmann::json::array();
  for (const PrefilteredMip& mip : mips)
    list.push_back({{"width", mip.map.width},
                    {"height", mip.map.height},
                    {"gloss", mip.gloss},
                    {"power", mip.power},
                    {"error", mip.error}});
  const nlohmann::ordered_json json = {
      {"time_h", time_h},
      {"lobe", "((1 + cos t)/2)^(power/2) max(cos t, 0), normalised, at the angle t from the texel's direction"},
      {"power", "2^(13 gloss)"},
      {"gloss", "1 - k/(n - 1) of mip k of n"},
      {"error",
       "largest at 16 axes: difference of a component, over the largest component there or of the sphere's mean"},
      {"mips", list}};
  return json.dump(2) + "\n";
}

}  // namespace welkin::maps
