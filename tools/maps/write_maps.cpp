// SPDX-License-Identifier: Apache-2.0
#include "maps/write_maps.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "format/cubemap_format.h"
#include "maps/dds.h"
#include "maps/ktx2.h"
#include "maps/prefiltered.h"
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

Content textOf(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {{bytes.begin(), bytes.end()}, 0};
}

/// Writes the maps of one request.
class MapWriter {
 public:
  MapWriter(const Request& request, std::filesystem::path folder, double luminance_unit)
      : request_(request), folder_(std::move(folder)), luminance_unit_(luminance_unit) {}

  void file(const std::string& name, const Content& content, std::optional<double> error = {}) {
    base::writeFile(folder_ / name, content.bytes);
    written.push_back({folder_ / name, content.bytes.size(), content.saturated, error});
  }

  void picture(const Map& map, const std::string& name, std::optional<double> error = {}) {
    const char* ending = request_.picture == PictureFormat::exr ? ".exr" : ".hdr";
    file(name + ending, pictureOf(map, request_.picture, luminance_unit_), error);
  }

  /// A latlong, or six faces.
  void pictures(const Map& map, const std::string& name, std::optional<double> error = {}) {
    if (request_.container == Container::latlong) return picture(map, name + "_latlong", error);
    for (int face = 0; face < 6; ++face) picture(faceOf(map, face), name + "_" + kFaceNames[face], error);
  }

  void cube(const EncodedCube& cube, const std::string& name, std::optional<double> error = {}) {
    if (request_.container == Container::ktx2)
      file(name + ".ktx2", {encodeKtx2(cube), cube.saturated}, error);
    else
      file(name + ".dds", {encodeDds(cube), cube.saturated}, error);
  }

  std::vector<WrittenFile> written;

 private:
  const Request& request_;
  std::filesystem::path folder_;
  double luminance_unit_;
};

void writePrefiltered(MapWriter& writer, std::vector<PrefilteredMip> mips, const Request& request,
                      const std::string& name, double time_h) {
  const std::string json = prefilterJson(mips, time_h);
  if (holdsTexels(request.container)) {
    std::vector<Map> levels;
    double error = 0.0;
    for (PrefilteredMip& mip : mips) {
      levels.push_back(std::move(mip.map));
      error = std::max(error, mip.error);
    }
    writer.cube(encodeLevels(levels, request.format), name, error);
  } else {
    for (std::size_t k = 0; k < mips.size(); ++k)
      writer.pictures(mips[k].map, name + "_mip" + std::to_string(k), mips[k].error);
  }
  writer.file(name + ".json", textOf(json));
}

}  // namespace

std::vector<WrittenFile> writeMaps(const WelkinSky* sky, const WelkinSkySample& sample, const Request& request,
                                   const std::filesystem::path& folder) {
  WelkinSkyInfo info;
  welkin_sky_info(sky, &info);
  const Orientation& orientation = request.engine ? *request.engine : welkinOrientation();
  const std::string time = bake::cubemapName(sample.time_h);
  const std::string name = request.engine ? time + "_" + request.engine->name : time;
  MapWriter writer(request, folder, double{info.luminance_unit});
  const bool latlong = request.container == Container::latlong;
  if (request.prefilter)
    writePrefiltered(
        writer, prefilter(sky, sample, orientation, latlong ? Projection::latlong : Projection::cube, request.size),
        request, name + "_prefiltered", sample.time_h);
  else if (latlong)
    writer.pictures(renderLatlong(sky, sample, orientation, 2 * request.size), name);
  else if (request.container == Container::faces)
    writer.pictures(renderCube(sky, sample, orientation, request.size), name);
  else
    writer.cube(encodeCube(renderCube(sky, sample, orientation, request.size), request.format, request.mips), name);
  writer.file(time + "_sh.json", textOf(shJson(info, sample)));
  return std::move(writer.written);
}

}  // namespace welkin::maps
