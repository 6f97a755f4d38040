// SPDX-License-Identifier: Apache-2.0
#include "study/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "sky/base/error.h"

namespace welkin::study {

std::vector<std::size_t> paretoFront(std::span<const Trade> trades) {
  for (std::size_t i = 0; i < trades.size(); ++i) {
    if (std::isnan(trades[i].cost) || std::isnan(trades[i].error)) {
      throw base::Error(base::ExitStatus::internal,
                        fmt::format("Pareto front: trade {} has cost {} and error {}; NaN has no order", i,
                                    trades[i].cost, trades[i].error));
    }
  }
  std::vector<std::size_t> order(trades.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(trades[i].cost, trades[i].error, i); });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || trades[i].error < trades[front.back()].error) front.push_back(i);
  }
  return front;
}

}  // namespace welkin::study
