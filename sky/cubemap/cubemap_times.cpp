// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_times.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"
#include "sky/cubemap/cubemap.h"
#include "sky/cubemap/day_bends.h"
#include "sky/cubemap/dome_directions.h"

namespace welkin::cubemap {
namespace {

constexpr std::size_t kDirections = 768;
constexpr std::size_t kProbes = 24;  // candidates of a gap that are looked at; every one of a shorter gap
constexpr int kMinutes = 1440;
constexpr std::size_t kRemembered = 192;  // distances of a candidate: to those at most so many after it

}  // namespace

DomeDay::DomeDay(const model::Sky& sky, const base::Progress& progress)
    : sky_(&sky), scale_(sky), bend_h_(bendsOf(sky)) {
  const DomeDirections even({kDirections, 0, 0});
  for (const Number3& d : even.staying()) rays_.emplace_back(sky.luminance, d);
  if (sky.luminance.d >= -model::IndicatrixTable::kSteepest) table_.emplace(sky.luminance.d);
  std::vector<double> time_h = bend_h_;
  for (int i = 0; i < kMinutes; ++i) time_h.push_back(i / 60.0);
  add(time_h, progress);
}

void DomeDay::add(const std::vector<double>& time_h, const base::Progress& progress) {
  std::vector<long> there;
  for (const double t : time_h_) there.push_back(millisecondOf(t));
  std::vector<long> fresh;
  for (const double t : time_h) fresh.push_back(millisecondOf(t));
  std::sort(fresh.begin(), fresh.end());
  fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
  std::erase_if(fresh, [&](long ms) { return std::binary_search(there.begin(), there.end(), ms); });

  std::vector<std::vector<float>> radiance;
  std::vector<Number3> scale_of;
  std::vector<double> all;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0, j = 0; i < there.size() || j < fresh.size();) {
    if (j == fresh.size() || (i < there.size() && there[i] < fresh[j])) {
      all.push_back(time_h_[i]);
      radiance.push_back(std::move(radiance_[i]));
      scale_of.push_back(scale_of_[i++]);
    } else {
      missing.push_back(all.size());
      all.push_back(static_cast<double>(fresh[j++]) / 3600000.0);
      radiance.emplace_back();
      scale_of.emplace_back(0.0);
    }
  }
  time_h_ = std::move(all);
  radiance_ = std::move(radiance);
  scale_of_ = std::move(scale_of);
  bend_.clear();
  for (const double bend : bend_h_)
    bend_.push_back(
        static_cast<std::size_t>(std::lower_bound(time_h_.begin(), time_h_.end(), bend - 1e-7) - time_h_.begin()));
  distance_ = std::make_unique<std::atomic<double>[]>(time_h_.size() * kRemembered * 3);
  for (std::size_t i = 0; i < time_h_.size() * kRemembered; ++i) distance_[3 * i] = -1.0;
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
    render(missing[i]);
    progress.step();
  });
}

void DomeDay::render(std::size_t index) {
  const model::SkyInstant instant(*sky_, time_h_[index]);
  std::vector<float>& rgb = radiance_[index];
  Number3 mean(0.0);
  for (const model::DomeRay& ray : rays_) {
    const Number3 radiance = instant.dome(ray, table_ ? &*table_ : nullptr);
    mean += radiance * (1.0 / kDirections);
    for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<float>(radiance[c]));
  }
  for (int c = 0; c < 3; ++c) scale_of_[index][c] = scale_.of(mean, c);
}

/// The mean over the directions of the squared difference of two candidates.
Number3 DomeDay::squaredDistance(std::size_t i, std::size_t j) const {
  const std::size_t n = time_h_.size();
  std::size_t after = j >= i ? j - i : j + n - i;
  if (2 * after > n) {
    i = j;
    after = n - after;
  }
  std::atomic<double>* const known = after < kRemembered ? &distance_[3 * (i * kRemembered + after)] : nullptr;
  if (known != nullptr && known[0].load(std::memory_order_acquire) >= 0.0) return {known[0], known[1], known[2]};
  const float* const a = radiance_[i].data();
  const float* const b = radiance_[i + after < n ? i + after : i + after - n].data();
  constexpr std::size_t kAtOnce = 12;  // numbers: whole directions, and sums that do not wait for each other
  static_assert(3 * kDirections % kAtOnce == 0);
  double sum[kAtOnce] = {};
  for (std::size_t at = 0; at < 3 * kDirections; at += kAtOnce)
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      const double difference = double{a[at + k]} - double{b[at + k]};
      sum[k] += difference * difference;
    }
  Number3 mean;
  for (std::size_t k = 0; k < kAtOnce; ++k) mean[static_cast<int>(k % 3)] += sum[k] / kDirections;
  if (known != nullptr) {
    known[2].store(mean.z, std::memory_order_relaxed);
    known[1].store(mean.y, std::memory_order_relaxed);
    known[0].store(mean.x, std::memory_order_release);
  }
  return mean;
}

double DomeDay::blendError(std::size_t first, std::size_t second, std::size_t at) const {
  const std::size_t n = time_h_.size();
  const auto inDay = [&](std::size_t i) { return i < n ? i : i - n; };
  const auto hour = [&](std::size_t i) { return i < n ? time_h_[i] : time_h_[i - n] + format::kDay_h; };
  const double weight = (hour(at) - hour(first)) / (hour(second) - hour(first));
  // Stewart's theorem: how far a point of the line through two others is from a third.
  const Number3 square = squaredDistance(inDay(first), inDay(at)) * (1.0 - weight) +
                         squaredDistance(inDay(second), inDay(at)) * weight -
                         squaredDistance(inDay(first), inDay(second)) * (weight * (1.0 - weight));
  double worst = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double scale = scale_of_[inDay(at)][c];
    if (scale > 0.0) worst = std::max(worst, std::sqrt(std::max(square[c], 0.0)) / scale);
  }
  return worst;
}

bool DomeDay::holds(std::size_t first, std::size_t second, std::span<const double> tolerance) const {
  const std::size_t n = time_h_.size();
  const auto fits = [&](std::size_t at) { return blendError(first, second, at) <= tolerance[at % n]; };
  const std::size_t inside = second - first - 1;
  const std::size_t probes = std::min(inside, kProbes);
  // From the middle out, where a blend that fails does so first.
  for (std::size_t k = 0; k < probes; ++k) {
    const std::size_t place = k % 2 == 0 ? probes / 2 + k / 2 : probes / 2 - k / 2 - 1;
    if (!fits(first + 1 + place * inside / probes)) return false;
  }
  if (probes == inside) return true;
  for (const std::size_t bend : bend_)
    for (std::size_t at = bend; at < second; at += n)
      if (at > first && !fits(at)) return false;
  return true;
}

std::vector<std::size_t> DomeDay::placeFrom(std::size_t start, std::span<const double> tolerance,
                                            std::size_t most) const {
  const std::size_t n = time_h_.size();
  const std::size_t end = start + n;
  std::vector<std::size_t> chosen;
  std::size_t stride = n;  // the last gap's: the next is about as long
  for (std::size_t first = start; first < end;) {
    if (chosen.size() == most) return {};
    chosen.push_back(first % n);
    std::size_t good = first + 1;
    std::size_t bad = end + 1;
    for (std::size_t reach = stride; good < end && bad > end; reach *= 2) {
      const std::size_t second = std::min(first + std::max<std::size_t>(reach, 2), end);
      (holds(first, second, tolerance) ? good : bad) = second;
    }
    while (bad - good > 1 && bad <= end) {
      const std::size_t second = good + (bad - good) / 2;
      (holds(first, second, tolerance) ? good : bad) = second;
    }
    stride = good - first;
    first = good;
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<std::size_t> DomeDay::starts() const {
  std::vector<std::size_t> list;
  constexpr std::size_t kEvenStarts = 6;
  for (std::size_t i = 0; i < kEvenStarts; ++i) list.push_back(i * time_h_.size() / kEvenStarts);
  for (std::size_t i = 0; i < bend_.size(); i += 1 + bend_.size() / kEvenStarts)
    list.push_back(bend_[i] % time_h_.size());
  return list;
}

std::vector<std::size_t> DomeDay::place(std::span<const double> tolerance, std::size_t most) const {
  const auto from = starts();
  std::vector<std::vector<std::size_t>> found(from.size());
  tbb::parallel_for(std::size_t{0}, from.size(),
                    [&](std::size_t i) { found[i] = placeFrom(from[i], tolerance, most); });
  std::vector<std::size_t> best;
  for (const auto& chosen : found)
    if (!chosen.empty() && (best.empty() || chosen.size() < best.size())) best = chosen;
  return best;
}

std::vector<std::size_t> DomeDay::placeQuickly(std::span<const double> tolerance, std::size_t most) const {
  return placeFrom(starts().back(), tolerance, most);
}

}  // namespace welkin::cubemap
