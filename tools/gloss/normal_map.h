// SPDX-License-Identifier: Apache-2.0
// A normal map as unit vectors, and the mistakes that a file of normals shows.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sky/image/image.h"

namespace welkin::gloss {

/// Something that is probably a mistake and does not stop the work.
struct Warning {
  std::string id;  ///< identifier for programs
  std::size_t count = 1;
  std::string message;
};

/// How the file's numbers stand for normals.
enum class Coding {
  codes,       ///< n = 2 v - 1, the only one of integers
  plain,       ///< n = v: floats, some of which are negative or whose length is 1 as they are
  two_channel  ///< n = 2 v - 1 for x and y; z is rebuilt, and > 0
};

const char* nameOf(Coding coding);

/// Unit normals in tangent space: x right, y up (glTF) or down (DirectX), z out of the surface. Rows from the top.
struct NormalMap {
  int width = 0;
  int height = 0;
  std::vector<float> xyz;
  Coding coding = Coding::codes;
  double mean_stored_length = 1.0;  ///< of the file's vectors, before they are normalised
  std::vector<Warning> warnings;
};

struct NormalMapOptions {
  bool decode_srgb = false;  ///< decodes codes that were sRGB-encoded by mistake
  bool repair = false;       ///< flat normals (0, 0, 1) in place of those without a direction
};

/// Largest side and most texels: 2^24 texels take about 1 GB.
inline constexpr image::ImageLimits kNormalLimits{16384, std::size_t{1} << 24, true};

/// Reads a normal map and normalises each vector. Throws Error(content), naming the file and the fault: three equal
/// channels, normals that were sRGB-encoded or decoded, vectors without a direction (shorter than 0.1) unless they are
/// repaired. Warns of vectors that are far from 1 long, of normals that point inward, of two-channel maps and of files
/// that are a mip or hold mips.
NormalMap readNormalMap(const std::filesystem::path& path, const NormalMapOptions& options = {});

/// The same from texels. `name` is for messages.
NormalMap normalMapOf(const std::string& name, image::Image codes, const NormalMapOptions& options);

}  // namespace welkin::gloss
