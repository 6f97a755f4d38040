// SPDX-License-Identifier: Apache-2.0
// Draws a few of many things in proportion to a number of each, by systematic sampling (Ward, "Adaptive Shadow Testing
// for Ray Tracing", 1991, sorts lights by the same number).
#pragma once

#include <cstddef>
#include <span>

namespace welkin::transfer {

/// Calls visit(i, amount) for each thing drawn, with the amount that its draws represent. `amount` has numbers >= 0.
/// The mean of what is represented over `offset`, uniform in (0, 1), is the amount itself. All things above 0 are drawn
/// if there are no more than `draws`.
template <typename Visit>
void drawInProportion(std::span<const double> amount, std::size_t draws, double offset, const Visit& visit) {
  double total = 0.0;
  std::size_t some = 0;
  for (const double a : amount) {
    total += a;
    if (a > 0.0) ++some;
  }
  if (some <= draws) {
    for (std::size_t i = 0; i < amount.size(); ++i)
      if (amount[i] > 0.0) visit(i, amount[i]);
    return;
  }
  const double step = total / static_cast<double>(draws);
  double sum = 0.0;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < amount.size() && drawn < draws; ++i) {
    sum += amount[i];
    std::size_t times = 0;
    for (; drawn < draws && (static_cast<double>(drawn) + offset) * step < sum; ++drawn) ++times;
    if (times > 0) visit(i, static_cast<double>(times) * step);
  }
}

}  // namespace welkin::transfer
