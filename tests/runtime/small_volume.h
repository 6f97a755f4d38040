// SPDX-License-Identifier: Apache-2.0
// Volumes on the CPU, and a level that they hold exactly.
#pragma once

#include <welkin/volume.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <vector>

#include "tests/runtime/random_level.h"

namespace welkin::tests {

struct Volume {
  WelkinVolume* volume = nullptr;
  explicit Volume(WelkinVolumeFormat format, std::array<std::uint32_t, 3> texels = {0, 0, 0}) {
    WelkinVolumeSettings settings{};
    settings.format = format;
    std::copy(texels.begin(), texels.end(), settings.texels);
    REQUIRE(welkin_volume_create(&settings, &volume) == WELKIN_OK);
  }
  Volume(const Volume&) = delete;
  Volume& operator=(const Volume&) = delete;
  ~Volume() { welkin_volume_destroy(volume); }

  WelkinVolumeUpdate update(OpenedLevel& level, const WelkinSkySample& sample, std::array<float, 3> camera,
                            std::uint32_t texels = UINT32_MAX) {
    WelkinVolumeUpdate result{};
    REQUIRE(welkin_volume_update(volume, level.level, &sample, camera.data(), texels, &result) == WELKIN_OK);
    return result;
  }
  std::vector<std::byte> bytes() const {
    std::vector<std::byte> all;
    for (std::uint32_t c = 0; c < 3; ++c) {
      const void* texels = nullptr;
      std::size_t size = 0;
      REQUIRE(welkin_volume_texels(volume, c, &texels, &size) == WELKIN_OK);
      const auto* first = static_cast<const std::byte*>(texels);
      all.insert(all.end(), first, first + size);
    }
    return all;
  }
};

/// A level whose grids are those of whole cells, as a bake makes them, without rooms.
inline RandomLevel wholeLevel(transfer::SunTransfer sun = transfer::SunTransfer::directional, int count = 2) {
  RandomLevel baked(count, 60, sun == transfer::SunTransfer::directional ? 6 : 0, sun, false);
  for (std::size_t i = 0; i < baked.sector.size(); ++i) {
    sectors::SectorFile& s = baked.sector[i];
    s.low_y = i == 0 ? 0.0 : -4.0;
    s.cell_height_m = 4.0;
    s.room.clear();
    s.door.clear();
    s.in_room.clear();
    baked.seal(i);
  }
  return baked;
}

}  // namespace welkin::tests
