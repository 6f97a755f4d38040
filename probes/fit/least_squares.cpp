// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/least_squares.h"

#include <algorithm>

namespace welkin::fit {

NormalMatrix::NormalMatrix(std::size_t unknowns, std::span<const Row> rows, double pull)
    : diagonal_(unknowns, 0.0), other_(unknowns) {
  std::vector<std::vector<std::uint32_t>> row_of(unknowns);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const Row::Entry& e : rows[i].entry) row_of[e.unknown].push_back(static_cast<std::uint32_t>(i));
  std::vector<double> line(unknowns, 0.0);
  std::vector<std::uint32_t> touched;
  double sum = 0.0;
  std::size_t used = 0;
  for (std::size_t u = 0; u < unknowns; ++u) {
    for (const std::uint32_t v : touched) line[v] = 0.0;
    touched.clear();
    for (const std::uint32_t i : row_of[u]) {
      const Row& row = rows[i];
      const auto own =
          std::find_if(row.entry.begin(), row.entry.end(), [&](const Row::Entry& e) { return e.unknown == u; });
      for (const Row::Entry& e : row.entry) {
        line[e.unknown] += row.weight * own->factor * e.factor;
        touched.push_back(e.unknown);
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    diagonal_[u] = line[u];
    for (const std::uint32_t v : touched)
      if (v != u && line[v] != 0.0) other_[u].push_back({v, line[v]});
    sum += diagonal_[u];
    used += diagonal_[u] > 0.0 ? 1 : 0;
  }
  pull_ = used > 0 ? pull * sum / static_cast<double>(used) : 1.0;
  for (double& d : diagonal_) d += pull_;
}

void NormalMatrix::addOthers(std::size_t unknown, std::span<const double> x, std::size_t columns,
                             std::span<double> sum) const {
  for (const Entry& e : other_[unknown]) {
    const std::span<const double> there = x.subspan(e.unknown * columns, columns);
    for (std::size_t c = 0; c < columns; ++c) sum[c] += e.value * there[c];
  }
}

}  // namespace welkin::fit
