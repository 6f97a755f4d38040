// SPDX-License-Identifier: Apache-2.0
#include "sky/table/key_placement.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "sky/table/farthest.h"

namespace welkin::table {

using det::Number3;
namespace {

/// The instants of a day as a closed loop.
class Round {
 public:
  Round(const DayValues& day, const Representation& r) : day_(day), r_(r), count_(day.day->instant.size()) {}

  std::size_t count() const { return count_; }
  double timeAt(std::size_t i) const {
    return day_.day->instant[i % count_].time_h + (i >= count_ ? format::kDay_h : 0.0);
  }
  const Number3* weightsAt(std::size_t i) const { return r_.weight.data() + i % count_ * r_.rows; }

  /// Whether interpolation from `first` to `last` keeps instant `between` within `error`.
  bool holds(std::size_t first, std::size_t last, std::size_t between, double error) const {
    const double weight = (timeAt(between) - timeAt(first)) / (timeAt(last) - timeAt(first));
    std::vector<Number3> row(r_.rows);
    for (std::size_t k = 0; k < r_.rows; ++k)
      row[k] = weightsAt(first)[k] * (1.0 - weight) + weightsAt(last)[k] * weight;
    return errorOf(day_, r_, between % count_, row).value <= error;
  }
  /// Whether all instants between hold. The middle ones come first, since they fail first.
  bool reaches(std::size_t first, std::size_t last, double error) const {
    const std::size_t inside = last - first - 1;
    for (std::size_t stride = std::bit_ceil(inside + 1); stride > 1; stride /= 2)
      for (std::size_t i = stride / 2; i <= inside; i += stride)
        if (!holds(first, last, first + i, error)) return false;
    return true;
  }

 private:
  const DayValues& day_;
  const Representation& r_;
  std::size_t count_;
};

bool oneKeyDoes(const DayValues& day, const Representation& r, double error) {
  const std::size_t count = day.day->instant.size();
  for (std::size_t stride = std::bit_ceil(count); stride > 1; stride /= 2)
    for (std::size_t i = stride / 2; i < count; i += stride)
      if (errorOf(day, r, i, {r.weight.data(), r.rows}).value > error) return false;
  return true;
}

/// A table's rows at an hour, from exact numbers or from decoded ones.
std::vector<Number3> rowsAt(const DayTable& table, const std::vector<double>& number, double time_h) {
  const auto s = format::findSegment(table.key_time_h, time_h);
  const auto channels = static_cast<std::size_t>(table.channels);
  std::vector<Number3> row(static_cast<std::size_t>(table.rows));
  for (std::size_t k = 0; k < row.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = k * channels + std::min(c, channels - 1);
      row[k][static_cast<int>(c)] = (1.0 - s.weight) * number[s.first * table.numbersOfKey() + at] +
                                    s.weight * number[s.second * table.numbersOfKey() + at];
    }
  return row;
}

}  // namespace

std::vector<std::size_t> placeKeys(const DayValues& day, const Representation& r, double error, std::size_t most) {
  const std::size_t count = day.day->instant.size();
  std::vector<char> holds(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    holds[i] = errorOf(day, r, i, {r.weight.data() + i * r.rows, r.rows}).value <= error;
  });
  if (std::find(holds.begin(), holds.end(), 0) != holds.end()) return {};
  if (oneKeyDoes(day, r, error)) return {0};

  const Round round(day, r);
  std::vector<std::size_t> keys = {0};
  std::size_t guess = 1;  // Length of the previous reach.
  while (keys.back() < count) {
    if (keys.size() > most) return {};
    const std::size_t first = keys.back();
    const std::size_t good =
        farthest(first, count, guess, [&](std::size_t next) { return round.reaches(first, next, error); });
    guess = std::max<std::size_t>(1, (good - first) * 3 / 4);
    keys.push_back(good);
  }
  keys.pop_back();  // The first key again.
  return keys;
}

DayTable tableAt(const DayValues& day, const Representation& r, const std::vector<std::size_t>& keys) {
  DayTable table;
  table.bands = r.bands;
  table.channels = isGrey(*day.day->sky) ? 1 : 3;
  table.rows = static_cast<int>(r.rows);
  table.modes = r.modes;
  for (const std::size_t key : keys) {
    table.key_time_h.push_back(day.day->instant[key].time_h);
    for (std::size_t k = 0; k < r.rows; ++k)
      for (int c = 0; c < table.channels; ++c) table.number.push_back(r.weight[key * r.rows + k][c]);
  }
  for (const DayInstant& at : day.day->instant) table.evaluations += at.field.moments.evaluations;
  return table;
}

TableError errorOf(const DayValues& day, const Representation& r, const DayTable& table, Encoding encoding) {
  const std::vector<double> number = decodeNumbers(table, encodeNumbers(table, encoding));
  std::vector<double> error(day.day->instant.size());
  tbb::parallel_for(std::size_t{0}, error.size(), [&](std::size_t i) {
    error[i] = errorOf(day, r, i, rowsAt(table, number, day.day->instant[i].time_h)).value;
  });
  TableError worst;
  for (std::size_t i = 0; i < error.size(); ++i)
    if (error[i] > worst.value) worst = {error[i], i};
  return worst;
}

ErrorParts partsOf(const DayValues& day, const Representation& r, const DayTable& table, Encoding encoding) {
  const std::vector<double> stored = decodeNumbers(table, encodeNumbers(table, encoding));
  std::vector<ErrorParts> parts(day.day->instant.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    const double time_h = day.day->instant[i].time_h;
    const std::span<const Number3> exact(r.weight.data() + i * r.rows, r.rows);
    const auto between = rowsAt(table, table.number, time_h);
    const auto rounded = rowsAt(table, stored, time_h);
    parts[i].truncation = errorOf(day, r, i, exact).value;
    parts[i].time = differenceOf(day, r, i, between, exact);
    parts[i].encoding = differenceOf(day, r, i, rounded, between);
  });
  ErrorParts worst;
  for (const ErrorParts& p : parts) {
    worst.truncation = std::max(worst.truncation, p.truncation);
    worst.time = std::max(worst.time, p.time);
    worst.encoding = std::max(worst.encoding, p.encoding);
  }
  return worst;
}

}  // namespace welkin::table
