// SPDX-License-Identifier: Apache-2.0
// A small sky in which every part differs from every other: asymmetric gradients, a tint, a moon, ground, cubemaps of
// noise.
#pragma once

#include <cstddef>
#include <vector>
#include <welkin/welkin.hpp>

#include "format/cubemap_format.h"

namespace welkin::tests {

struct TestSkyOptions {
  bool cubemaps = true;
  bool normalise_to_sun = true;
  double disc_radius_rad = 0.0;
  format::CubemapFormat cubemap_format = format::CubemapFormat::rgba16f;
  uint8_t mode_count = 0;  ///< 1 to 8: the day's numbers are weights of modes of noise
  unsigned day = 0;        ///< skies that differ in this alone are of one family
};

/// Edge of the test sky's cubemaps, texels.
inline constexpr uint32_t kCubemapSize = 8;

/// Size of the modes' map.
inline constexpr uint16_t kModeColumns = 9;
inline constexpr uint16_t kModeRows = 6;

/// Returns the bytes of a .welkin file.
std::vector<std::byte> testSkyFile(const TestSkyOptions& options);

/// Returns that file opened. `bytes` must outlive the sky.
Sky openTestSky(const std::vector<std::byte>& bytes);

}  // namespace welkin::tests
