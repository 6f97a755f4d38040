// SPDX-License-Identifier: Apache-2.0
#include "study/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "sky/base/error.h"

namespace welkin::study {

std::vector<std::size_t> paretoFront(std::span<const Tradeoff> tradeoffs) {
  for (std::size_t i = 0; i < tradeoffs.size(); ++i) {
    if (std::isnan(tradeoffs[i].cost) || std::isnan(tradeoffs[i].error)) {
      throw base::Error(base::ExitStatus::internal,
                        fmt::format("Pareto front: trade {} has cost {} and error {}; NaN has no order", i,
                                    tradeoffs[i].cost, tradeoffs[i].error));
    }
  }
  std::vector<std::size_t> order(tradeoffs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(tradeoffs[i].cost, tradeoffs[i].error, i); });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || tradeoffs[i].error < tradeoffs[front.back()].error) front.push_back(i);
  }
  return front;
}

}  // namespace welkin::study
