// SPDX-License-Identifier: Apache-2.0
#include "gloss/integrability.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace welkin::gloss {
namespace {

constexpr int kBlocks = 16;           // along an axis
constexpr double kSteepest = 1e-2;    // least z: the slope of a steeper normal is mostly its rounding
constexpr double kQuantised = 1e-12;  // sums of products below this are those of a flat map

struct Slopes {
  double right, up;
};

Slopes slopesAt(const NormalMap& map, int column, int row) {
  const auto i =
      3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(column));
  const double z = std::max(double{map.xyz[i + 2]}, kSteepest);
  return {-double{map.xyz[i]} / z, -double{map.xyz[i + 1]} / z};
}

int neighbour(int i, int by, int size, Wrap wrap) {
  const int at = i + by;
  return wrap == Wrap::repeat ? (at + size) % size : std::clamp(at, 0, size - 1);
}

/// Sums over the texels of a block.
struct Products {
  double across = 0.0, p = 0.0, q = 0.0;
};

Products productsOf(const NormalMap& map, Wrap wrap, int left, int right, int top, int bottom) {
  Products sum;
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column) {
      const auto at = [&](int dx, int dy) {
        return slopesAt(map, neighbour(column, dx, map.width, wrap), neighbour(row, dy, map.height, wrap));
      };
      const double p_up = at(0, -1).right - at(0, 1).right;
      const double q_right = at(1, 0).up - at(-1, 0).up;
      sum.across += p_up * q_right;
      sum.p += p_up * p_up;
      sum.q += q_right * q_right;
    }
  return sum;
}

/// The chance that a normal variable is below t.
double normalShare(double t) {
  return 0.5 * std::erfc(-t / std::sqrt(2.0));
}

}  // namespace

GreenDirection greenDirectionOf(const NormalMap& map, Wrap wrap) {
  const int columns = std::clamp(map.width / 4, 1, kBlocks), rows = std::clamp(map.height / 4, 1, kBlocks);
  std::vector<Products> block(static_cast<std::size_t>(columns * rows));
  tbb::parallel_for(0, columns * rows, [&](int b) {
    const int x = b % columns, y = b / columns;
    block[static_cast<std::size_t>(b)] = productsOf(map, wrap, map.width * x / columns, map.width * (x + 1) / columns,
                                                    map.height * y / rows, map.height * (y + 1) / rows);
  });
  Products sum;
  for (const Products& b : block) sum = {sum.across + b.across, sum.p + b.p, sum.q + b.q};
  if (sum.p * sum.q < kQuantised) return {};
  GreenDirection found;
  found.correlation = std::clamp(sum.across / std::sqrt(sum.p * sum.q), -1.0, 1.0);
  const auto n = static_cast<double>(block.size());
  const double mean = sum.across / n;
  double variance = 0.0;
  for (const Products& b : block) variance += (b.across - mean) * (b.across - mean);
  if (n > 1.0 && variance > 0.0) found.certainty = normalShare(std::abs(mean) / std::sqrt(variance / (n * (n - 1.0))));
  return found;
}

}  // namespace welkin::gloss
