// SPDX-License-Identifier: Apache-2.0
#include "sky/image/pixel_aspect.h"

#include <fmt/format.h>

#include <cmath>

namespace welkin::image {

void notePixelAspect(const std::string& field, double aspect, Image& image) {
  constexpr double kSquare = 1e-3;  // densities are rounded: 2834 and 2835 a metre
  if (std::abs(aspect - 1.0) > kSquare)
    image.notes.push_back(fmt::format("{}: pixels are {:.6g} times as wide as high; this is not used", field, aspect));
}

}  // namespace welkin::image
