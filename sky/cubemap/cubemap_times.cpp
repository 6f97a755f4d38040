// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_times.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"

namespace welkin::cubemap {
namespace {

constexpr int kDirections = 768;
constexpr std::size_t kProbes = 24;  // candidates of a gap that are looked at; every one of a shorter gap
constexpr int kMinutes = 1440;

}  // namespace

DomeDay::DomeDay(const model::Sky& sky, const table::Progress& progress)
    : sky_(&sky), scale_(sky), directions_({kDirections, 0, 0}), bend_h_(bendsOf(sky)) {
  std::vector<double> time_h = bend_h_;
  for (int i = 0; i < kMinutes; ++i) time_h.push_back(i / 60.0);
  add(time_h, progress);
}

void DomeDay::add(const std::vector<double>& time_h, const table::Progress& progress) {
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
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
    render(missing[i]);
    if (progress && !progress()) throw base::Error(base::ExitStatus::interrupted, "interrupted");
  });
}

void DomeDay::render(std::size_t index) {
  const model::SkyInstant instant(*sky_, time_h_[index]);
  std::vector<float>& rgb = radiance_[index];
  Number3 mean(0.0);
  for (const Number3& d : directions_.even()) {
    const Number3 radiance = instant.dome(d, Number3(0.0));
    mean += radiance * (1.0 / kDirections);
    for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<float>(radiance[c]));
  }
  for (int c = 0; c < 3; ++c) scale_of_[index][c] = scale_.of(mean, c);
}

double DomeDay::blendError(std::size_t first, std::size_t second, std::size_t at) const {
  const std::size_t n = time_h_.size();
  const auto hour = [&](std::size_t i) { return time_h_[i % n] + 24.0 * static_cast<double>(i / n); };
  const auto weight = static_cast<float>((hour(at) - hour(first)) / (hour(second) - hour(first)));
  const std::vector<float>& a = radiance_[first % n];
  const std::vector<float>& b = radiance_[second % n];
  const std::vector<float>& model = radiance_[at % n];
  float sum[3] = {};
  for (std::size_t i = 0; i < model.size(); i += 3)
    for (std::size_t c = 0; c < 3; ++c) {
      const float difference = a[i + c] + weight * (b[i + c] - a[i + c]) - model[i + c];
      sum[c] += difference * difference;
    }
  double worst = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double scale = scale_of_[at % n][c];
    if (scale > 0.0) worst = std::max(worst, std::sqrt(double{sum[c]} / kDirections) / scale);
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
  for (const double bend : bend_h_) {  // the next candidate at or after it
    const auto after = std::lower_bound(time_h_.begin(), time_h_.end(), bend - 1e-7) - time_h_.begin();
    for (std::size_t at = static_cast<std::size_t>(after); at < second; at += n)
      if (at > first && !fits(at)) return false;
  }
  return true;
}

std::vector<std::size_t> DomeDay::placeFrom(std::size_t start, std::span<const double> tolerance,
                                            std::size_t most) const {
  const std::size_t n = time_h_.size();
  const std::size_t end = start + n;
  std::vector<std::size_t> chosen;
  std::size_t stride = n;  // of the last gap: the next is about as long
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
  constexpr std::size_t kEven = 6;
  for (std::size_t i = 0; i < kEven; ++i) list.push_back(i * time_h_.size() / kEven);
  for (std::size_t i = 0; i < bend_h_.size(); i += 1 + bend_h_.size() / kEven) {
    const auto after = std::lower_bound(time_h_.begin(), time_h_.end(), bend_h_[i] - 1e-7) - time_h_.begin();
    list.push_back(static_cast<std::size_t>(after) % time_h_.size());
  }
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
