// SPDX-License-Identifier: Apache-2.0
#include "view/beside.h"

#include <algorithm>
#include <cmath>

namespace welkin::view {
namespace {

constexpr uint8_t kLine = 230;

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
  const uint32_t half = a.width / 2;
  const uint32_t from = (a.width - half) / 2;
  return joined(a, from, b, std::min(from, half), half);
}

}  // namespace welkin::view
