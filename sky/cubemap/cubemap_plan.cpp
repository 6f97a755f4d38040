// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sky/cubemap/cubemap_still_errors.h"
#include "sky/cubemap/cubemap_times.h"

namespace welkin::cubemap {
namespace {

using format::CubemapFormat;

constexpr double kMargin = 0.97;  // the aim, as a share of the budget, so that Effort::full agrees
constexpr double kSpare = 1.05;   // a plan this far below its aim is tried again with fewer bytes
constexpr int kRounds = 12;
constexpr int kLower = 6;  // then so many targets, each a tenth lower

double bytesOf(int size, CubemapFormat format, std::size_t times) {
  return static_cast<double>(format::bytesOfCubemaps(format, static_cast<std::uint64_t>(size), times));
}

/// Whether a bake would make the same cubemaps.
bool isSame(const CubemapPlan& a, const CubemapPlan& b) {
  return a.size == b.size && a.format == b.format && a.time_h == b.time_h;
}

/// The error that one choice of size and format leaves to the times.
struct Candidate {
  int size;
  CubemapFormat format;
  std::vector<double> tolerance;  ///< at DomeDay's candidates, > 0
  std::vector<double> fixed;      ///< there: resolution and encoding
};

class Planner {
 public:
  Planner(const model::Sky& sky, const CubemapLimits& limits, const base::Progress& progress)
      : sky_(sky),
        limits_(limits),
        progress_(progress),
        day_(sky, progress),
        still_errors_(sky, limits.largest_size, progress),
        excess_(day_.time_h().size(), 1.0) {}

  /// The least plan for a target by the model of squares, not yet measured; none when the limits leave none.
  std::optional<CubemapPlan> choose(double target) const { return choose(target, limits_.most_bytes); }
  std::optional<CubemapPlan> choose(double target, double most_bytes) const {
    const Candidate* best = nullptr;
    std::vector<std::size_t> best_places;
    const std::vector<Candidate> list = candidates(target);
    // Bytes, then texels: less is better.
    const auto costOf = [](const Candidate& candidate, std::size_t times) {
      const double bytes = bytesOf(candidate.size, candidate.format, times);
      return std::pair(bytes, bytes / static_cast<double>(format::texelBytes(candidate.format)));
    };
    for (const Candidate& candidate : list) {
      // As many times as would still be a gain.
      const double one = costOf(candidate, 1).first;
      const double bytes = best != nullptr ? costOf(*best, best_places.size()).first : most_bytes;
      const auto most =
          static_cast<std::size_t>(std::min(std::floor(bytes / one), static_cast<double>(limits_.most_times)));
      if (most == 0 || day_.placeQuickly(candidate.tolerance, most + most / 16 + 1).empty()) continue;
      auto places = day_.place(candidate.tolerance, most);
      if (places.empty()) continue;
      if (best != nullptr && costOf(candidate, places.size()) >= costOf(*best, best_places.size())) continue;
      best = &candidate;
      best_places = std::move(places);
    }
    if (best == nullptr) return std::nullopt;
    CubemapPlan plan;
    plan.size = best->size;
    plan.format = best->format;
    best_places = evened(*best, std::move(best_places));
    for (const std::size_t i : best_places) plan.time_h.push_back(day_.time_h()[i]);
    plan.bytes = bytesOf(plan.size, plan.format, plan.time_h.size());
    plan.predicted = predict(*best, best_places);
    return plan;
  }

  /// Measures the cubemaps that a bake would make. False when their error is past `aim`, as a draft finds of most.
  bool keeps(CubemapPlan& plan, double aim) const {
    for (const Effort effort : {Effort::draft, Effort::fast}) {
      plan.measured = measureCubemaps(sky_, {plan.size, plan.format, plan.time_h, {}}, effort, progress_);
      if (plan.measured.error > aim) return false;
    }
    return true;
  }

  /// Expects `more` times the measured error where a gap or a cubemap is past `target`.
  void tighten(const CubemapPlan& plan, double target, double more) {
    std::vector<double> fresh;
    std::vector<double> worst(plan.time_h.size(), 0.0);
    double at_cubemaps = 0.0;
    for (const auto& at : plan.measured.day) {
      const format::KeySegment gap = format::findSegment(plan.time_h, at.time_h);
      if (gap.weight == 0.0 && plan.time_h.size() > 1)
        at_cubemaps = std::max(at_cubemaps, at.error);
      else
        worst[gap.first] = std::max(worst[gap.first], at.error);
    }
    if (at_cubemaps > target) still_ *= more * at_cubemaps / target;
    for (std::size_t i = 0; i < plan.time_h.size(); ++i)
      if (worst[i] > target) raise(plan, i, std::min(more * worst[i] / target, 4.0), fresh);
    if (!fresh.empty()) {
      const auto before = day_.time_h();
      day_.add(fresh, progress_);
      std::vector<double> excess;
      for (const double t : day_.time_h()) excess.push_back(excess_[format::findSegment(before, t).first]);
      excess_ = std::move(excess);
    }
  }

  /// When no plan keeps the aim: the least error that is found with ever larger targets.
  CubemapPlan leastError(double aim, double max_error) const {
    CubemapPlan best;
    for (double target = aim; best.time_h.empty() || best.measured.error > max_error; target *= 1.1) {
      auto plan = choose(target);
      if (!plan) continue;
      keeps(*plan, max_error);
      if (!best.time_h.empty() && plan->measured.error >= best.measured.error) break;
      best = std::move(*plan);
    }
    best.met = best.measured.error <= max_error;
    if (best.met) return best;
    constexpr double kMostBytes = CubemapLimits{}.most_bytes;
    if (limits_.most_bytes < kMostBytes)
      if (const auto wanted = choose(aim, kMostBytes)) best.wanted_bytes = wanted->bytes;
    best.reason = fmt::format(
        "the least error found within {} texels a face, {} times and {:.3g} bytes is {:.4g} (resolution {:.2g}, time "
        "{:.2g}, encoding {:.2g})",
        limits_.largest_size, limits_.most_times, limits_.most_bytes, best.measured.error,
        best.measured.parts.resolution, best.measured.parts.time, best.measured.parts.encoding);
    return best;
  }

 private:
  std::vector<Candidate> candidates(double target) const {
    std::vector<Candidate> list;
    for (int size = kSmallestCubemap; size <= limits_.largest_size; size *= 2) {
      for (const CubemapFormat format : kPlannedFormats) {
        Candidate candidate{size, format, {}, {}};
        bool possible = true;
        for (std::size_t i = 0; i < day_.time_h().size(); ++i) {
          const double fixed = still_ * still_errors_.at(size, format, day_.time_h()[i]);
          possible = fixed < target;
          if (!possible) break;
          candidate.fixed.push_back(fixed);
          candidate.tolerance.push_back(std::sqrt(target * target - fixed * fixed) / excess_[i]);
        }
        if (possible) list.push_back(std::move(candidate));
      }
    }
    return list;
  }

  /// The model of squares, at the worst of DomeDay's candidates.
  double predict(const Candidate& candidate, const std::vector<std::size_t>& places) const {
    const std::size_t n = excess_.size();
    double worst = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::size_t second = k + 1 < places.size() ? places[k + 1] : places.front() + n;
      for (std::size_t at = places[k]; at < second; ++at) {
        const double time = at == places[k] ? 0.0 : excess_[at % n] * day_.blendError(places[k], second, at);
        worst = std::max(worst, time * time + candidate.fixed[at % n] * candidate.fixed[at % n]);
      }
    }
    return std::sqrt(worst);
  }

  /// As many times at the least common share of their tolerances.
  std::vector<std::size_t> evened(const Candidate& candidate, std::vector<std::size_t> places) const {
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 4; ++step) {
      const double share = 0.5 * (low + high);
      std::vector<double> tolerance;
      for (const double t : candidate.tolerance) tolerance.push_back(share * t);
      auto tighter = day_.place(tolerance, places.size());
      if (tighter.empty()) {
        low = share;
      } else {
        high = share;
        places = std::move(tighter);
      }
    }
    return places;
  }

  /// Expects more between cubemap i and the next; between neighbouring candidates, puts more of them.
  void raise(const CubemapPlan& plan, std::size_t i, double factor, std::vector<double>& fresh) {
    const double from = plan.time_h[i];
    const double to = i + 1 < plan.time_h.size() ? plan.time_h[i + 1] : plan.time_h.front() + format::kDay_h;
    std::size_t inside = 0;
    for (std::size_t k = 0; k < excess_.size(); ++k) {
      const double t = day_.time_h()[k];
      const bool in = (t > from && t < to) || t + format::kDay_h < to;
      if (!in) continue;
      ++inside;
      excess_[k] *= factor;
    }
    if (inside < 3)
      for (int k = 1; k < 8; ++k) fresh.push_back(format::wrapTime(from + (to - from) * k / 8.0));
  }

  const model::Sky& sky_;
  const CubemapLimits limits_;
  const base::Progress& progress_;
  DomeDay day_;
  CubemapStillErrors still_errors_;
  std::vector<double> excess_;  ///< by DomeDay's candidates: measured over expected error between cubemaps
  double still_ = 1.0;          ///< the same at the cubemaps' own times
};

}  // namespace

CubemapPlan planCubemaps(const model::Sky& sky, double max_error, const CubemapLimits& limits,
                         const base::Progress& progress) {
  Planner planner(sky, limits, progress);
  const double aim = kMargin * max_error;
  CubemapPlan best;  // that keeps the aim
  CubemapPlan last;  // that does not keep it
  double target = aim;
  for (int round = 0; round < kRounds; ++round) {
    std::optional<CubemapPlan> plan = planner.choose(target);
    if (!plan || (best.met && plan->bytes >= best.bytes)) break;
    if (isSame(*plan, last))
      plan->measured = std::move(last.measured);
    else
      plan->met = planner.keeps(*plan, aim);
    if (plan->met) {
      best = std::move(*plan);
      const double spare = aim / best.measured.error;
      if (spare < kSpare) break;
      target *= std::min(spare, 1.5);  // the squares expected too much: ask for the rest
    } else {
      planner.tighten(*plan, aim, 1.02 + 0.01 * round);
      last = std::move(*plan);
    }
  }
  // Rounds that end short of the aim, though more cubemaps may be had: lower targets, until the limits leave none.
  for (int step = 0; !best.met && step < kLower; ++step) {
    std::optional<CubemapPlan> plan = planner.choose(target *= 0.9);
    if (!plan) break;
    plan->met = planner.keeps(*plan, aim);
    best = std::move(*plan);
  }
  return best.met ? best : planner.leastError(aim, max_error);
}

}  // namespace welkin::cubemap
