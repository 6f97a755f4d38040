// SPDX-License-Identifier: Apache-2.0
#include "maps/sh_json.h"

#include <nlohmann/json.hpp>

namespace welkin::maps {
namespace {

nlohmann::ordered_json channelsOf(const float (*sh)[3], std::uint32_t count) {
  nlohmann::ordered_json channels;
  for (int c = 0; c < 3; ++c) {
    nlohmann::ordered_json& channel = channels[std::string(1, "rgb"[c])] = nlohmann::json::array();
    for (std::uint32_t i = 0; i < count; ++i) channel.push_back(double{sh[i][c]});
  }
  return channels;
}

}  // namespace

std::string shJson(const WelkinSkyInfo& info, const WelkinSkySample& sample) {
  const nlohmann::ordered_json json = {
      {"time_h", sample.time_h},
      {"luminance_unit", double{info.luminance_unit}},
      {"units", "radiance in scene units: 1 is luminance_unit cd/m2; linear, Rec. 709 primaries, D65"},
      {"basis", "real, orthonormal, no Condon-Shortley phase, index l (l + 1) + m"},
      {"axes", "right-handed, +x east, +y up, -z north"},
      {"bands", info.bands},
      {"modes", info.mode_count},
      {"radiance_sh", channelsOf(sample.radiance_sh, sample.coefficient_count)},
      {"ambient_sh", channelsOf(sample.ambient_sh, sample.coefficient_count)}};
  return json.dump(2) + "\n";
}

}  // namespace welkin::maps
