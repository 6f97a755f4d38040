// SPDX-License-Identifier: Apache-2.0
#include "sky/table/plan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "sky/base/error.h"

namespace welkin::table {

using det::Number3;
namespace {

constexpr std::size_t kInstantsApart = 4;  // in the first look at a candidate; keys are placed with all instants

/// Indices of the instants at fixed keys. Every fixed key was sampled.
std::vector<std::size_t> fixedKeys(const DayValues& day, const std::vector<double>& time_h) {
  std::vector<std::size_t> keys;
  for (std::size_t i = 0; i < day.day->instant.size(); ++i)
    if (std::binary_search(time_h.begin(), time_h.end(), day.day->instant[i].time_h)) keys.push_back(i);
  return keys;
}

class Planner {
 public:
  Planner(const DayValues& day, const PlanRequest& request, const base::Progress& progress)
      : day_(day), request_(request), progress_(progress) {
    plan_.bytes = SIZE_MAX;
  }

  DayPlan run() {
    collect();
    if (candidates_.empty()) return std::move(plan_);
    least_keys_ = leastKeys();
    const double close_enough = request_.max_error;
    tryAll([&](const Candidate& candidate) { return candidate.choice.error <= close_enough; });
    for (Candidate& candidate : candidates_)
      if (mayFit(candidate) && candidate.choice.error > close_enough &&
          candidate.choice.error < kWorthFitting * close_enough &&
          leastBytes(candidate.representation, format::kEncodings.back()) < plan_.bytes)
        fit(candidate);
    tryAll([&](const Candidate& candidate) { return candidate.fitted && candidate.choice.error <= close_enough; });
    if (!plan_.met) takeTheBest(*std::min_element(candidates_.begin(), candidates_.end(), byError));
    for (Candidate& candidate : candidates_) plan_.considered.push_back(std::move(candidate.choice));
    return std::move(plan_);
  }

 private:
  /// A representation of the day, and how it does.
  struct Candidate {
    Representation representation;
    PlanChoice choice;
    bool fitted = false;
  };
  static bool byError(const Candidate& a, const Candidate& b) { return a.choice.error < b.choice.error; }
  bool mayFit(const Candidate& candidate) const {
    return candidate.representation.modes || request_.reconstruction != Reconstruction::projected;
  }

  void fit(Candidate& candidate) {
    progress_.check();
    fitWeights(day_, candidate.representation);
    candidate.choice.name = candidate.representation.name();
    candidate.choice.error = errorAtKeys(day_, candidate.representation);
    candidate.fitted = true;
  }

  void add(Representation r) {
    progress_.check();
    const double error = errorAtKeys(day_, r);
    std::string name = r.name();
    candidates_.push_back({std::move(r), {std::move(name), error}});
  }
  void collect() {
    if (request_.shared) {
      const SharedModes& m = *request_.shared;
      add(modesOf(day_, *m.set, weightsOf(day_, *m.set), m.columns, m.rows, request_.bands.value_or(kFallbackBands)));
      return;
    }
    const int most = request_.sh_bands > 0 ? request_.sh_bands : 5;
    if (request_.reconstruction != Reconstruction::modes)
      for (int bands = request_.bands.value_or(2); bands <= request_.bands.value_or(most); ++bands)
        if (bands != 4 || request_.bands)  // Irradiance has no band 3: four bands would equal three.
          add(coefficientsOf(day_, bands, request_.reconstruction == Reconstruction::fitted));
    if (request_.sh_bands > 0 || (request_.reconstruction && request_.reconstruction != Reconstruction::modes)) return;
    const DayModes modes(*day_.day, *day_.grid);
    const int bands = request_.bands.value_or(kFallbackBands);
    for (std::size_t count = 1; count <= DayModes::kMost; ++count) {
      const ModeSet set = modes.best(count);
      if (set.count() < count) break;  // The day has no more modes.
      const std::vector<Number3> weights = weightsOf(day_, set);
      const MapSize& finest = kMaps[std::size(kMaps) - 1];
      add(modesOf(day_, set, weights, finest.columns, finest.rows, bands));
      if (candidates_.back().choice.error > kWorthFitting * request_.max_error) continue;
      for (const MapSize& map : kMaps)
        if (&map != &finest) add(modesOf(day_, set, weights, map.columns, map.rows, bands));
    }
  }

  /// Number of keys of the candidate with the least error. No other one needs far fewer.
  std::size_t leastKeys() const {
    if (!request_.key_time_h.empty()) return request_.key_time_h.size();
    const auto closest = std::min_element(candidates_.begin(), candidates_.end(), byError);
    return std::max<std::size_t>(1, placeKeys(day_, closest->representation, request_.max_error).size());
  }
  std::size_t bytesOfKey(const Representation& r, Encoding encoding) const {
    return format::bytesOfKey(encoding, r.rows * (isGrey(*day_.day->sky) ? 1 : 3));
  }
  std::size_t leastBytes(const Representation& r, Encoding encoding) const {
    return r.fixedBytes() + least_keys_ * bytesOfKey(r, encoding);
  }

  /// Tries the candidates that `wanted` accepts, by growing least bytes, until none left can be smaller than the best.
  template <typename Wanted>
  void tryAll(Wanted&& wanted) {
    struct Trial {
      Candidate* candidate;
      Encoding encoding;
      std::size_t least_bytes;
    };
    std::vector<Trial> trials;
    for (Candidate& candidate : candidates_)
      for (auto e = format::kEncodings.rbegin(); e != format::kEncodings.rend(); ++e)  // of equal bytes the coarser
        if (wanted(candidate) && (!request_.encoding || *e == *request_.encoding))
          trials.push_back({&candidate, *e, leastBytes(candidate.representation, *e)});
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& a, const Trial& b) { return a.least_bytes < b.least_bytes; });
    for (const Trial& t : trials)
      if (t.least_bytes < plan_.bytes) tryOne(*t.candidate, t.encoding);
  }

  /// Places keys for an error that is lowered until the stored numbers keep the requested one.
  void tryOne(Candidate& candidate, Encoding encoding) {
    const Representation& r = candidate.representation;
    double aim = request_.max_error;
    for (int attempt = 0; attempt < 5 && aim >= candidate.choice.error; ++attempt) {
      progress_.check();
      const std::size_t most_keys = (plan_.bytes - r.fixedBytes()) / bytesOfKey(r, encoding);
      const auto keys =
          request_.key_time_h.empty() ? placeKeys(day_, r, aim, most_keys) : fixedKeys(day_, request_.key_time_h);
      if (keys.empty()) return;
      DayTable table = tableAt(day_, r, keys);
      const std::size_t bytes = bytesOf(r, table, encoding);
      if (bytes >= plan_.bytes) return;
      const double error = errorOf(day_, r, table, encoding).value;
      if (error <= request_.max_error) {
        plan_.met = true;
        plan_.representation = r;
        plan_.table = std::move(table);
        plan_.encoding = encoding;
        plan_.predicted_error = error;
        plan_.bytes = candidate.choice.bytes = bytes;
        candidate.choice.keys = keys.size();
        return;
      }
      if (!request_.key_time_h.empty()) return;
      aim = std::min(aim - (error - request_.max_error), 0.98 * aim);
    }
  }

  /// Used where no fewer keys meet the error: every instant becomes a key and nothing is rounded.
  void takeTheBest(Candidate& candidate) {
    if (mayFit(candidate) && !candidate.fitted) fit(candidate);
    plan_.representation = candidate.representation;
    plan_.encoding = request_.encoding.value_or(Encoding::float32);
    std::vector<std::size_t> keys(day_.day->instant.size());
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = i;
    if (!request_.key_time_h.empty()) keys = fixedKeys(day_, request_.key_time_h);
    plan_.table = tableAt(day_, plan_.representation, keys);
    plan_.predicted_error = errorOf(day_, plan_.representation, plan_.table, plan_.encoding).value;
    plan_.bytes = bytesOf(plan_.representation, plan_.table, plan_.encoding);
    plan_.met = plan_.predicted_error <= request_.max_error;
  }

  const DayValues& day_;
  const PlanRequest& request_;
  const base::Progress& progress_;
  std::vector<Candidate> candidates_;
  std::size_t least_keys_ = 1;
  DayPlan plan_;
};

}  // namespace

double errorAtKeys(const DayValues& day, const Representation& r) {
  std::vector<double> error((day.day->instant.size() + kInstantsApart - 1) / kInstantsApart);
  tbb::parallel_for(std::size_t{0}, error.size(), [&](std::size_t i) {
    const std::size_t at = i * kInstantsApart;
    error[i] = errorOf(day, r, at, {r.weight.data() + at * r.rows, r.rows}).value;
  });
  return *std::max_element(error.begin(), error.end());
}

std::size_t bytesOf(const Representation& r, const DayTable& table, Encoding encoding) {
  return r.fixedBytes() + format::bytesOfTable(encoding, table.key_time_h.size(), table.numbersOfKey());
}

DayPlan planDay(const DayValues& day, const PlanRequest& request, const base::Progress& progress) {
  return Planner(day, request, progress).run();
}

}  // namespace welkin::table
