// SPDX-License-Identifier: Apache-2.0
#include "sky/image/orientation.h"

#include <algorithm>
#include <utility>

namespace welkin::image {

Orientation orientationOfTag(int tag) {
  if (tag < 1 || tag > 8) return {};
  // 2 and 3 come from the right, 3 and 4 from the bottom; 5 to 8 are columns, of which 6 and 7 come from the right, 7
  // and 8 from the bottom.
  const bool columns = tag >= 5;
  const int corner = columns ? tag - 4 : tag;
  return {columns, corner == 3 || corner == 4, corner == 2 || corner == 3};
}

void turnUpright(Orientation orientation, Image& image) {
  if (!orientation.columns && !orientation.up && !orientation.left) return;
  const auto length = static_cast<std::size_t>(image.width), lines = static_cast<std::size_t>(image.height);
  const std::size_t width = orientation.columns ? lines : length;
  const std::size_t height = orientation.columns ? length : lines;
  std::vector<float> rgb(image.rgb.size());
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      std::size_t row = orientation.up ? height - 1 - y : y;
      std::size_t column = orientation.left ? width - 1 - x : x;
      if (orientation.columns) std::swap(row, column);  // a line of the file is a column of the picture
      std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (row * length + column)), 3,
                  rgb.begin() + static_cast<std::ptrdiff_t>(3 * (y * width + x)));
    }
  image.rgb = std::move(rgb);
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
}

}  // namespace welkin::image
