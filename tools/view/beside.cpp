// SPDX-License-Identifier: Apache-2.0
#include "view/beside.h"

#include <algorithm>
#include <cmath>

namespace welkin::view {
namespace {

constexpr uint8_t kLine = 230;

/// Side by side: the first of two pictures up to column `line`, from its column `first_from` on, then the second.
struct Halves {
  uint32_t line, first_from, second_from;
};

Halves halvesOf(uint32_t width) {
  const uint32_t half = width / 2;
  const uint32_t from = (width - half) / 2;
  return {half, from, std::min(from, half)};
}

/// `a` up to column `line`, then `b` from its column `from` on.
render::Picture joined(const render::Picture& a, uint32_t a_from, const render::Picture& b, uint32_t b_from,
                       uint32_t line) {
  render::Picture picture = a;
  for (uint32_t y = 0; y < a.height; ++y) {
    const auto row = [&](const render::Picture& p, uint32_t x) {
      return p.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (std::size_t{y} * p.width + x));
    };
    const auto out = picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{y} * a.width);
    std::copy_n(row(a, a_from), 3 * line, out);
    std::copy_n(row(b, b_from), 3 * (a.width - line), out + 3 * line);
    if (line > 0 && line < a.width) std::fill_n(out + 3 * line, 3, kLine);
  }
  return picture;
}

}  // namespace

render::Picture wiped(const render::Picture& a, const render::Picture& b, double at) {
  const auto line = static_cast<uint32_t>(std::lround(std::clamp(at, 0.0, 1.0) * a.width));
  return joined(a, 0, b, line, line);
}

render::Picture sideBySide(const render::Picture& a, const render::Picture& b) {
  const Halves h = halvesOf(a.width);
  return joined(a, h.first_from, b, h.second_from, h.line);
}

double sideColumn(double x, uint32_t width) {
  const Halves h = halvesOf(width);
  return x < h.line ? x + h.first_from : x - h.line + h.second_from;
}

}  // namespace welkin::view
