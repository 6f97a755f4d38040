// SPDX-License-Identifier: Apache-2.0
#include "maps/write_maps.h"

#include <cstring>
#include <span>

#include "format/cubemap_format.h"
#include "maps/dds.h"
#include "maps/ktx2.h"
#include "maps/radiance_hdr.h"
#include "maps/sh_json.h"
#include "maps/sky_map.h"
#include "sky/bake/sky_outputs.h"
#include "sky/base/atomic_file.h"
#include "sky/cubemap/exr.h"

namespace welkin::maps {
namespace {

constexpr const char* kFaceNames[6] = {"px", "nx", "py", "ny", "pz", "nz"};

/// A file's content, and how many components were past its largest number.
struct Content {
  std::vector<std::byte> bytes;
  std::size_t saturated = 0;
};

Content exrOf(const Map& map, double luminance_unit) {
  cubemap::DomeImage image{{map.width, map.height}, {}, 0};
  image.rgb_half.resize(map.rgb.size());
  for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
    const float rgb[3] = {map.rgb[i], map.rgb[i + 1], map.rgb[i + 2]};
    unsigned char texel[format::kMostTexelBytes];
    image.saturated += format::encodeTexel(format::CubemapFormat::rgba16f, rgb, texel);
    std::memcpy(image.rgb_half.data() + i, texel, 3 * sizeof(std::uint16_t));
  }
  return {cubemap::encodeExr(image, std::nullopt, luminance_unit), image.saturated};
}

Content pictureOf(const Map& map, PictureFormat format, double luminance_unit) {
  if (format == PictureFormat::exr) return exrOf(map, luminance_unit);
  RadianceFile file = encodeRadiance(map);
  return {std::move(file.bytes), file.saturated};
}

}  // namespace

std::vector<WrittenFile> writeMaps(const WelkinSky* sky, const WelkinSkySample& sample, const Request& request,
                                   const std::filesystem::path& folder) {
  WelkinSkyInfo info;
  welkin_sky_info(sky, &info);
  const Orientation& orientation = request.engine ? *request.engine : welkinOrientation();
  const std::string time = bake::cubemapName(sample.time_h);
  const std::string name = request.engine ? time + "_" + request.engine->name : time;
  std::vector<WrittenFile> written;
  const auto write = [&](const std::string& file, const Content& content) {
    base::writeFile(folder / file, content.bytes);
    written.push_back({folder / file, content.bytes.size(), content.saturated});
  };
  const auto picture = [&](const Map& map, const std::string& part) {
    const char* ending = request.picture == PictureFormat::exr ? ".exr" : ".hdr";
    write(name + "_" + part + ending, pictureOf(map, request.picture, double{info.luminance_unit}));
  };
  if (request.container == Container::latlong) {
    picture(renderLatlong(sky, sample, orientation, 2 * request.size), "latlong");
  } else {
    const Map cube = renderCube(sky, sample, orientation, request.size);
    if (request.container == Container::faces) {
      for (int face = 0; face < 6; ++face) picture(faceOf(cube, face), kFaceNames[face]);
    } else {
      const EncodedCube encoded = encodeCube(cube, request.format, request.mips);
      if (request.container == Container::ktx2)
        write(name + ".ktx2", {encodeKtx2(encoded), encoded.saturated});
      else
        write(name + ".dds", {encodeDds(encoded), encoded.saturated});
    }
  }
  const std::string json = shJson(info, sample);
  const auto bytes = std::as_bytes(std::span(json));
  write(time + "_sh.json", {{bytes.begin(), bytes.end()}, 0});
  return written;
}

}  // namespace welkin::maps
