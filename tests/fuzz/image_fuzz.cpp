// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a gradient's image, in any supported format.
#include <algorithm>

#include "fuzz.h"
#include "sky/image/image.h"
#include "sky/image/image_module.h"

/// Loads the module before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  welkin::image::imageModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  static const fuzz::Folder kFolder;
  const auto path = kFolder.write("image", {bytes, size});
  image::Image image;
  if (!fuzz::accepts([&] { image = image::readImage(path); })) return 0;
  const image::ImageLimits limits;
  fuzz::require(image.width >= 1 && image.width <= limits.largest_side && image.height >= 1 &&
                    image.height <= limits.largest_side,
                "the sides are within the limits");
  const auto texels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  fuzz::require(texels <= limits.most_texels && image.rgb.size() == 3 * texels, "every texel is there");
  fuzz::require(std::all_of(image.rgb.begin(), image.rgb.end(), [](float v) { return std::isfinite(v) && v >= 0.0F; }),
                "values are finite and not negative");
  return 0;
}
