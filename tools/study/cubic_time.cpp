// SPDX-License-Identifier: Apache-2.0
#include "study/cubic_time.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "sky/table/farthest.h"

namespace welkin::study {
namespace {

using det::Number3;

/// Instants of a day, repeated every day.
class PeriodicDay {
 public:
  PeriodicDay(const table::DayValues& day, const table::Representation& r)
      : day_(day), r_(r), count_(day.day->instant.size()) {}

  std::size_t count() const { return count_; }
  double timeAt(std::size_t i) const {
    return day_.day->instant[i % count_].time_h + format::kDay_h * static_cast<double>(i / count_);
  }
  const Number3* weightsAt(std::size_t i) const { return r_.weight.data() + i % count_ * r_.rows; }
  double errorAt(std::size_t i, const std::vector<Number3>& rows) const {
    return table::errorOf(day_, r_, i % count_, rows).value;
  }
  std::size_t rows() const { return r_.rows; }

 private:
  const table::DayValues& day_;
  const table::Representation& r_;
  std::size_t count_;
};

/// Hermite's cubic at u in [0, 1] between values a and b with slopes already times the interval.
Number3 hermite(const Number3& a, const Number3& slope_a, const Number3& b, const Number3& slope_b, double u) {
  const double v = 1.0 - u;
  return a * (v * v * (1.0 + 2.0 * u)) + b * (u * u * (1.0 + 2.0 * v)) + slope_a * (u * v * v) - slope_b * (u * u * v);
}

/// The key's index among the instants, `offset` keys away, over midnight.
std::size_t keyAt(const std::vector<std::size_t>& keys, std::size_t count, std::size_t k, int offset) {
  const auto n = static_cast<long>(keys.size());
  long at = static_cast<long>(k) + offset + n;  // a day later: no negative index
  return keys[static_cast<std::size_t>(at % n)] + static_cast<std::size_t>(at / n) * count;
}

/// Largest error over the segments between keys of `rowsAt(segment, instant)`.
template <typename RowsAt>
double largestError(const PeriodicDay& periodic, const std::vector<std::size_t>& keys, const RowsAt& rowsAt) {
  std::vector<double> error(keys.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t k) {
    const std::size_t first = keyAt(keys, periodic.count(), k, 0);
    const std::size_t last = keyAt(keys, periodic.count(), k, 1);
    for (std::size_t i = first; i < last; ++i) error[k] = std::max(error[k], periodic.errorAt(i, rowsAt(k, i)));
  });
  return *std::max_element(error.begin(), error.end());
}

std::vector<Number3> linearRows(const PeriodicDay& periodic, std::size_t first, std::size_t last, std::size_t i) {
  const double u = (periodic.timeAt(i) - periodic.timeAt(first)) / (periodic.timeAt(last) - periodic.timeAt(first));
  std::vector<Number3> rows(periodic.rows());
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = periodic.weightsAt(first)[k] * (1.0 - u) + periodic.weightsAt(last)[k] * u;
  return rows;
}

/// The cubic with the slopes of the instants next to the ends, inside.
bool hermiteReaches(const PeriodicDay& periodic, std::size_t first, std::size_t last, double error) {
  const double interval = periodic.timeAt(last) - periodic.timeAt(first);
  const double start = periodic.timeAt(first + 1) - periodic.timeAt(first);
  const double end = periodic.timeAt(last) - periodic.timeAt(last - 1);
  const auto holds = [&](std::size_t i) {
    const double u = (periodic.timeAt(i) - periodic.timeAt(first)) / interval;
    std::vector<Number3> rows(periodic.rows());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Number3& a = periodic.weightsAt(first)[k];
      const Number3& b = periodic.weightsAt(last)[k];
      rows[k] = hermite(a, (periodic.weightsAt(first + 1)[k] - a) * (interval / start), b,
                        (b - periodic.weightsAt(last - 1)[k]) * (interval / end), u);
    }
    return periodic.errorAt(i, rows) <= error;
  };
  const std::size_t inside = last - first - 1;
  for (std::size_t stride = std::bit_ceil(inside + 1); stride > 1; stride /= 2)
    for (std::size_t i = stride / 2; i <= inside; i += stride)
      if (!holds(first + i)) return false;
  return true;
}

}  // namespace

double linearError(const table::DayValues& day, const table::Representation& r, const std::vector<std::size_t>& keys) {
  const PeriodicDay periodic(day, r);
  return largestError(periodic, keys, [&](std::size_t k, std::size_t i) {
    return linearRows(periodic, keyAt(keys, periodic.count(), k, 0), keyAt(keys, periodic.count(), k, 1), i);
  });
}

double catmullRomError(const table::DayValues& day, const table::Representation& r,
                       const std::vector<std::size_t>& keys) {
  if (keys.size() < 3) return linearError(day, r, keys);
  const PeriodicDay periodic(day, r);
  // The slope at key b of the parabola through a, b and c.
  const auto slope = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t row) {
    const double before = periodic.timeAt(b) - periodic.timeAt(a);
    const double after = periodic.timeAt(c) - periodic.timeAt(b);
    const Number3 rise_before = (periodic.weightsAt(b)[row] - periodic.weightsAt(a)[row]) * (1.0 / before);
    const Number3 rise_after = (periodic.weightsAt(c)[row] - periodic.weightsAt(b)[row]) * (1.0 / after);
    return (rise_before * after + rise_after * before) * (1.0 / (before + after));
  };
  return largestError(periodic, keys, [&](std::size_t k, std::size_t i) {
    const std::size_t p[4] = {keyAt(keys, periodic.count(), k, -1), keyAt(keys, periodic.count(), k, 0),
                              keyAt(keys, periodic.count(), k, 1), keyAt(keys, periodic.count(), k, 2)};
    const double interval = periodic.timeAt(p[2]) - periodic.timeAt(p[1]);
    const double u = (periodic.timeAt(i) - periodic.timeAt(p[1])) / interval;
    std::vector<Number3> rows(periodic.rows());
    for (std::size_t row = 0; row < rows.size(); ++row)
      rows[row] = hermite(periodic.weightsAt(p[1])[row], slope(p[0], p[1], p[2], row) * interval,
                          periodic.weightsAt(p[2])[row], slope(p[1], p[2], p[3], row) * interval, u);
    return rows;
  });
}

std::vector<std::size_t> placeHermiteKeys(const table::DayValues& day, const table::Representation& r, double error) {
  const PeriodicDay periodic(day, r);
  const std::size_t count = periodic.count();
  for (std::size_t i = 0; i < count; ++i)
    if (periodic.errorAt(i, {periodic.weightsAt(i), periodic.weightsAt(i) + periodic.rows()}) > error) return {};
  std::vector<std::size_t> keys = {0};
  while (keys.back() < count) {
    const std::size_t first = keys.back();
    keys.push_back(table::farthest(first, count, 2,
                                   [&](std::size_t next) { return hermiteReaches(periodic, first, next, error); }));
  }
  keys.pop_back();  // the first again
  return keys;
}

}  // namespace welkin::study
