// SPDX-License-Identifier: Apache-2.0
// Writes a baked sky at one time as the files that an engine reads.
#pragma once

#include <welkin/welkin.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "maps/encoded_cube.h"
#include "maps/orientation.h"

namespace welkin::maps {

/// Largest face, texels along an edge.
inline constexpr int kLargestFace = 4096;

enum class Container {
  ktx2,    ///< one file: a cube
  dds,     ///< one file: a cube
  faces,   ///< six pictures: px, nx, py, ny, pz, nz
  latlong  ///< one picture of 4 N x 2 N texels
};

/// Whether a container holds the texels of a GPU's format: a cube in one file.
constexpr bool holdsTexels(Container container) {
  return container == Container::ktx2 || container == Container::dds;
}

enum class PictureFormat { exr, hdr };

/// The files to write.
struct Request {
  std::optional<Orientation> engine;  ///< none: Welkin's own orientation, and no engine in names
  Container container = Container::ktx2;
  Format format = Format::rgba16f;             ///< of a cube in one file
  PictureFormat picture = PictureFormat::exr;  ///< of faces and latlongs
  int size = 0;                                ///< N, texels along a face's edge, 1 to kLargestFace
  bool mips = false;                           ///< of a cube in one file: box-filtered mips down to one texel
  bool prefilter = false;                      ///< every mip filtered for a gloss; N is 2 to kLargestPrefiltered
};

struct WrittenFile {
  std::filesystem::path path;
  std::size_t bytes = 0;
  std::size_t saturated = 0;    ///< components past the format's largest number, stored as that
  std::optional<double> error;  ///< of prefiltered maps: the largest of PrefilteredMip::error
};

/// Writes the maps of the sample, and its spherical harmonics as JSON, to a folder that exists. Names carry the time,
/// as in sky_063000000_three.ktx2 for 6:30. Prefiltered pictures are one a mip, and a JSON file tells gloss and error.
/// Every file appears whole or not at all. Throws Error(file).
std::vector<WrittenFile> writeMaps(const WelkinSky* sky, const WelkinSkySample& sample, const Request& request,
                                   const std::filesystem::path& folder);

}  // namespace welkin::maps
