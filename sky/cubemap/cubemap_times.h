// SPDX-License-Identifier: Apache-2.0
// The times of cubemaps in the day: the fewest between which a linear blend of the model's dome stays close to it.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sky/base/progress.h"
#include "sky/cubemap/dome_scale.h"
#include "sky/table/day_table.h"

namespace welkin::cubemap {

using det::Number3;

/// The dome at candidate times, whole milliseconds of the day: every minute and where the sky bends.
class DomeDay {
 public:
  explicit DomeDay(const model::Sky& sky, const base::Progress& progress = {});

  /// Ascending, distinct, in [0, 24).
  const std::vector<double>& time_h() const { return time_h_; }

  /// More candidates; those that are there already are left out.
  void add(const std::vector<double>& time_h, const base::Progress& progress = {});

  /// The error, as CubemapError's, at candidate `at` of a blend between candidates `first` and `second` > first;
  /// indices past the last are of the next day. `second` = `first` plus all candidates: of one cubemap alone.
  double blendError(std::size_t first, std::size_t second, std::size_t at) const;

  /// The fewest candidates, ascending, such that the blend's error at no other candidate is past that one's tolerance
  /// (each > 0), or close to the fewest: from each of a few first ones the farthest next one is taken, again and again.
  /// Empty when there are more than `most`.
  std::vector<std::size_t> place(std::span<const double> tolerance, std::size_t most) const;

  /// Does as place, from one first candidate: quicker, at times one more.
  std::vector<std::size_t> placeQuickly(std::span<const double> tolerance, std::size_t most) const;

 private:
  void render(std::size_t index);
  Number3 squaredDistance(std::size_t i, std::size_t j) const;
  bool holds(std::size_t first, std::size_t second, std::span<const double> tolerance) const;
  std::vector<std::size_t> placeFrom(std::size_t start, std::span<const double> tolerance, std::size_t most) const;
  std::vector<std::size_t> starts() const;

  const model::Sky* sky_;
  DomeScale scale_;
  std::vector<model::DomeRay> rays_;
  std::optional<model::IndicatrixTable> table_;
  std::vector<double> time_h_;
  std::vector<double> bend_h_;
  std::vector<std::size_t> bend_;             ///< candidates at the bends, or the next ones after them
  std::vector<std::vector<float>> radiance_;  ///< by candidate: direction, RGB
  std::vector<Number3> scale_of_;             ///< by candidate, each channel
  /// Squared distances of a candidate and those after it, each channel, from when they are first asked for; below 0
  /// before.
  std::unique_ptr<std::atomic<double>[]> distance_;
};

}  // namespace welkin::cubemap
