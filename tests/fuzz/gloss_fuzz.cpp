// SPDX-License-Identifier: Apache-2.0
// Fuzz target: a normal map, as the bytes of a picture or as bare floats, through the mips and the blocks. The first
// byte chooses: bits 0 and 1 are the options, bit 2 bare floats, whose sides are the next two bytes.
#include <algorithm>
#include <cstring>

#include "fuzz.h"
#include "gloss/block_texture.h"
#include "gloss/integrability.h"
#include "gloss/mips.h"
#include "sky/image/image_module.h"

namespace {

using namespace welkin;

constexpr image::ImageLimits kLimits{64, 2048, true};

/// Finite floats of a map; nothing if there are too few.
image::Image bareFloats(std::span<const std::uint8_t> bytes) {
  image::Image image;
  if (bytes.size() < 2) return image;
  const int width = 1 + bytes[0] % 32, height = 1 + bytes[1] % 32;
  image.rgb.resize(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.rgb.size() && bytes.size() >= 6; ++i) {
    const std::size_t at = 2 + 4 * i % (bytes.size() - 5);  // few bytes repeat
    std::memcpy(&image.rgb[i], bytes.data() + at, sizeof(float));
    if (!std::isfinite(image.rgb[i])) return image;
  }
  image.width = width;
  image.height = height;
  return image;
}

void requireMip(const gloss::Mip& mip) {
  for (std::size_t i = 0; i < mip.gloss.size(); ++i) {
    fuzz::require(mip.gloss[i] >= 0.0F && mip.gloss[i] <= 1.0F, "gloss is in [0, 1]");
    const float* n = mip.normal.data() + 3 * i;
    const double length = std::hypot(double{n[0]}, double{n[1]}, double{n[2]});
    fuzz::require(std::abs(length - 1.0) < 1e-6, "normals are unit vectors");
  }
  fuzz::require(mip.least_length >= 0.0 && mip.least_length <= 1.0, "a mean is no longer than its normals");
  fuzz::require(mip.mean_factor >= 0.0 && mip.mean_factor <= 1.0 + 1e-12, "no power rises");
}

}  // namespace

/// Loads the module before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  image::imageModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  static const fuzz::Folder kFolder;
  const std::span<const std::uint8_t> rest(bytes + 1, size - 1);
  const gloss::NormalMapOptions options{(bytes[0] & 1U) != 0, (bytes[0] & 2U) != 0};
  gloss::NormalMap map;
  const auto read = [&] {
    image::Image codes =
        (bytes[0] & 4U) != 0 ? bareFloats(rest) : image::readCodes(kFolder.write("picture", rest), kLimits);
    if (codes.width > 0) map = gloss::normalMapOf("picture", std::move(codes), options);
  };
  if (!fuzz::accepts(read) || map.width == 0) return 0;
  const gloss::GreenDirection green = gloss::greenDirectionOf(map, gloss::Wrap::repeat);
  fuzz::require(green.correlation >= -1.0 && green.correlation <= 1.0, "a correlation is in [-1, 1]");
  fuzz::require(green.certainty >= 0.5 && green.certainty <= 1.0, "a certainty is in [0.5, 1]");
  gloss::GlossMap number;
  number.number = bytes[0] / 255.0;
  const auto mips = gloss::mipsOf(map, number);
  for (const gloss::Mip& mip : mips) requireMip(mip);
  const gloss::BlockError error = gloss::packBc3(mips, std::nullopt).error;
  fuzz::require(std::isfinite(error.angle_rms) && error.angle_most <= 180.0 + 1e-9, "angles are angles");
  return 0;
}
