// SPDX-License-Identifier: Apache-2.0
#include "calibrate/albedo_file.h"

#include <Imath/half.h>

#include <algorithm>
#include <cmath>

#include "calibrate/tiff.h"
#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"
#include "sky/cubemap/exr.h"

namespace welkin::calibrate {
namespace {

constexpr float kLargestHalf = 65504.0F;

std::vector<std::byte> exrOf(const image::Image& albedo) {
  cubemap::DomeImage halves;
  halves.extent.width = albedo.width;
  halves.extent.height = albedo.height;
  halves.rgb_half.reserve(albedo.rgb.size());
  for (const float v : albedo.rgb) halves.rgb_half.push_back(Imath::half(std::min(v, kLargestHalf)).bits());
  return cubemap::encodeExr(halves, std::nullopt, 1.0);
}

std::vector<std::uint16_t> codesOf(const image::Image& albedo) {
  std::vector<std::uint16_t> code;
  code.reserve(albedo.rgb.size());
  for (const float v : albedo.rgb) {
    const double encoded = det::srgbEncode(std::clamp(double{v}, 0.0, 1.0));
    code.push_back(static_cast<std::uint16_t>(std::lround(65535.0 * encoded)));
  }
  return code;
}

}  // namespace

void writeAlbedo(const std::filesystem::path& path, const image::Image& albedo) {
  if (path.extension() == ".png")
    base::writeFile(path, image::encodePng(albedo.width, albedo.height, codesOf(albedo)));
  else if (path.extension() == ".tif")
    base::writeFile(path, encodeTiff(albedo.width, albedo.height, codesOf(albedo)));
  else
    base::writeFile(path, exrOf(albedo));
}

}  // namespace welkin::calibrate
