// SPDX-License-Identifier: Apache-2.0
// Bilinear reading of the modes' map, as a GPU filters it. The centres of the outer texels are at coordinates 0 and 1.
#pragma once

#include <algorithm>
#include <cstddef>

namespace welkin::format {

/// The four texels around a place, and its distance from the lower left one.
struct ModeTexels {
  std::size_t left, right, low, high;
  double across, upwards;  ///< [0, 1]

  /// The interpolated value; texel(column, row) gives the value of one texel.
  template <typename Texel>
  double blend(Texel&& texel) const {
    return (1.0 - upwards) * ((1.0 - across) * texel(left, low) + across * texel(right, low)) +
           upwards * ((1.0 - across) * texel(left, high) + across * texel(right, high));
  }
};

/// `column` and `row`: coordinates in [0, 1], as modeColumn and modeRow give them. At least one column and row.
inline ModeTexels modeTexelsAt(double column, double row, std::size_t columns, std::size_t rows) {
  const double x = column * static_cast<double>(columns - 1);
  const double y = row * static_cast<double>(rows - 1);
  const auto left = static_cast<std::size_t>(x);
  const auto low = static_cast<std::size_t>(y);
  return {left,
          std::min(left + 1, columns - 1),
          low,
          std::min(low + 1, rows - 1),
          x - static_cast<double>(left),
          y - static_cast<double>(low)};
}

}  // namespace welkin::format
