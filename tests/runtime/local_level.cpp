// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/local_level.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace welkin::tests {
namespace {

using f64::Number3;

Number3 numbers(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

double distanceOf(const Number3& a, const Number3& b) {
  return std::sqrt(dot(a - b, a - b));
}

}  // namespace

Number3 virtualLightOf(const RandomLevel& level, std::size_t sector, std::size_t light) {
  const auto& position = level.sector[sector].local->encoded.position;
  return geometry::cornerOf(level.sector[sector].id) + numbers(&position[3 * light]);
}

ReferenceLight referenceLight(const RandomLevel& level, const std::vector<WelkinPointLight>& lamps,
                              const transfer::SeeEachOther& see) {
  std::vector<Number3> lights;  // of all lists, each once
  std::vector<std::vector<std::size_t>> index(level.sector.size());
  for (std::size_t s = 0; s < level.sector.size(); ++s)
    for (std::size_t l = 0; l < level.sector[s].local->encoded.position.size() / 3; ++l) {
      const Number3 place = virtualLightOf(level, s, l);
      const auto same =
          std::find_if(lights.begin(), lights.end(), [&](const Number3& p) { return distanceOf(p, place) < 1e-3; });
      index[s].push_back(static_cast<std::size_t>(same - lights.begin()));
      if (same == lights.end()) lights.push_back(place);
    }
  std::vector<transfer::DynamicLight> dynamic;
  for (const WelkinPointLight& lamp : lamps) {
    dynamic.push_back({numbers(lamp.position), numbers(lamp.intensity)});
    if (lamp.outer_rad == 0.0F) continue;
    dynamic.back().axis = numbers(lamp.direction);
    dynamic.back().inner_rad = double{lamp.inner_rad};
    dynamic.back().outer_rad = double{lamp.outer_rad};
  }
  const auto near = [&](const Number3& light, const Number3& lamp) {
    return distanceOf(light, lamp) <= 64.0 && see(light, lamp);
  };
  const transfer::LocalColours colours = transfer::relightLocal(lights, dynamic, near);
  ReferenceLight reference;
  reference.unseen = colours.unseen.size();
  for (std::size_t s = 0; s < level.sector.size(); ++s) {
    std::vector<Number3> own;
    for (const std::size_t l : index[s]) own.push_back(colours.colour[l]);
    auto& probes = reference.sector.emplace_back();
    for (const auto& transfer : transfer::decodedLocal(level.sector[s].local->encoded).probe) {
      probes.push_back(transfer::relitLocal(transfer, own));
      for (const Number3& e : probes.back())
        reference.largest = std::max({reference.largest, std::abs(e.x), std::abs(e.y), std::abs(e.z)});
    }
  }
  return reference;
}

WelkinColours lightOfProbe(const RandomLevel& level, const OpenedLevel& opened, std::size_t sector, std::size_t probe) {
  const sectors::SectorFile& file = level.sector[sector];
  const auto found = std::find(file.grid.begin(), file.grid.end(), probe);
  REQUIRE(found != file.grid.end());
  const auto cell = found - file.grid.begin();
  const Number3 corner = geometry::cornerOf(file.id);
  const float middle[1][3] = {
      {static_cast<float>(corner.x + 4.0 * (static_cast<double>(cell % 16) + 0.5)),
       static_cast<float>(file.low_y + file.cell_height_m * (static_cast<double>(cell / 16 % 16) + 0.5)),
       static_cast<float>(corner.z + 4.0 * (static_cast<double>(cell / 256) + 0.5))}};
  WelkinColours colours;
  std::uint8_t served = 0;
  REQUIRE(welkin_level_colours(opened.level, 1, middle, &colours, &served) == WELKIN_OK);
  REQUIRE(served == 1);
  return colours;
}

std::vector<WelkinColours> lightOfProbes(const RandomLevel& level, const OpenedLevel& opened) {
  std::vector<WelkinColours> all;
  for (std::size_t s = 0; s < level.sector.size(); ++s)
    for (std::size_t p = 0; p < level.sector[s].probes.sky_scale.size(); ++p)
      all.push_back(lightOfProbe(level, opened, s, p));
  return all;
}

WelkinLightsResult setLamps(OpenedLevel& opened, const std::vector<WelkinPointLight>& lamps, WelkinSees sees,
                            void* user) {
  WelkinLightsResult result{};
  REQUIRE(welkin_level_set_lights(opened.level, static_cast<std::uint32_t>(lamps.size()), lamps.data(), sees, user,
                                  &result) == WELKIN_OK);
  opened.relight(12.0, 0, 0, 1);
  return result;
}

WelkinPointLight lampAt(const Number3& position, const Number3& intensity) {
  WelkinPointLight lamp{};
  for (int c = 0; c < 3; ++c) {
    lamp.position[c] = static_cast<float>(position[c]);
    lamp.intensity[c] = static_cast<float>(intensity[c]);
  }
  return lamp;
}

WelkinPointLight spotAt(const Number3& position, const Number3& intensity, const Number3& axis, double inner_rad,
                        double outer_rad) {
  WelkinPointLight lamp = lampAt(position, intensity);
  for (int c = 0; c < 3; ++c) lamp.direction[c] = static_cast<float>(axis[c]);
  lamp.inner_rad = static_cast<float>(inner_rad);
  lamp.outer_rad = static_cast<float>(outer_rad);
  return lamp;
}

}  // namespace welkin::tests
