// SPDX-License-Identifier: Apache-2.0
#include "sky/table/family_plan.h"

#include <algorithm>
#include <deque>

namespace welkin::table {
namespace {

/// Functions that all members may weigh.
struct Choice {
  std::optional<SharedModes> modes;  ///< none: coefficients
  int bands = 0;
  double error = 0.0;           ///< largest at the keys of any member
  double ratio = 0.0;           ///< largest such error over its member's budget
  std::size_t least_bytes = 0;  ///< that the family could take
  std::string name = {};
};

class FamilyPlanner {
 public:
  FamilyPlanner(std::span<const FamilyMember> family, const base::Progress& progress)
      : family_(family), progress_(progress) {}

  std::vector<DayPlan> run() {
    collectCoefficients();
    collectModes();
    bound();
    std::stable_sort(choices_.begin(), choices_.end(),
                     [](const Choice& a, const Choice& b) { return a.least_bytes < b.least_bytes; });
    for (const Choice& choice : choices_)
      if (choice.least_bytes < bytes_ && choice.ratio < kWorthFitting) tryOne(choice);
    if (best_.empty() && !choices_.empty())
      best_ = planWith(*std::min_element(choices_.begin(), choices_.end(),
                                         [](const Choice& a, const Choice& b) { return a.ratio < b.ratio; }));
    for (DayPlan& plan : best_) {
      std::vector<PlanChoice> considered;
      for (const Choice& choice : choices_) {
        const bool chosen = choice.name == plan.representation.name();
        considered.push_back({choice.name, choice.error, chosen ? plan.table.key_time_h.size() : 0,
                              chosen ? plan.bytes : std::size_t{0}});
      }
      plan.considered = std::move(considered);
    }
    return std::move(best_);
  }

 private:
  const PlanRequest& common() const { return family_.front().request; }
  int fallbackBands() const { return common().bands.value_or(kFallbackBands); }

  /// Adds a choice, given how each member would hold its day.
  template <typename RepresentationOf>
  void add(Choice choice, const RepresentationOf& representationOf) {
    progress_.check();
    for (const FamilyMember& member : family_) {
      const Representation r = representationOf(*member.day);
      const double error = errorAtKeys(*member.day, r);
      choice.error = std::max(choice.error, error);
      choice.ratio = std::max(choice.ratio, error / member.request.max_error);
      choice.least_bytes += r.fixedBytes();
      choice.name = r.name();
    }
    choices_.push_back(std::move(choice));
  }

  void collectCoefficients() {
    if (common().reconstruction == Reconstruction::modes) return;
    const int most = common().sh_bands > 0 ? common().sh_bands : 5;
    const bool fitted = common().reconstruction == Reconstruction::fitted;
    for (int bands = common().bands.value_or(2); bands <= common().bands.value_or(most); ++bands)
      if (bands != 4 || common().bands)  // irradiance has no band 3
        add({std::nullopt, bands}, [&](const DayValues& day) { return coefficientsOf(day, bands, fitted); });
  }

  void collectModes() {
    if (common().sh_bands > 0 || (common().reconstruction && common().reconstruction != Reconstruction::modes)) return;
    std::vector<const DayFields*> days;
    for (const FamilyMember& member : family_) days.push_back(member.day->day);
    const DayModes modes(days, *family_.front().day->grid);
    for (std::size_t count = 1; count <= DayModes::kMost; ++count) {
      const ModeSet& set = sets_.emplace_back(modes.best(count));
      if (set.count() < count) break;  // the days have no more modes
      std::vector<std::vector<Number3>> weights;
      for (const FamilyMember& member : family_) weights.push_back(weightsOf(*member.day, set));
      const auto addMap = [&](const MapSize& map) {
        std::size_t i = 0;
        add({SharedModes{&set, map.columns, map.rows}, fallbackBands()}, [&](const DayValues& day) {
          return modesOf(day, set, weights[i++], map.columns, map.rows, fallbackBands());
        });
      };
      const MapSize& finest = kMaps[std::size(kMaps) - 1];
      addMap(finest);
      if (choices_.back().ratio > kWorthFitting) continue;
      for (const MapSize& map : kMaps)
        if (&map != &finest) addMap(map);
    }
  }

  /// Adds the bytes of the fewest keys that any choice could do with.
  void bound() {
    if (choices_.empty()) return;
    const Choice& closest = *std::min_element(choices_.begin(), choices_.end(),
                                              [](const Choice& a, const Choice& b) { return a.ratio < b.ratio; });
    for (const FamilyMember& member : family_) {
      const PlanRequest& request = member.request;
      std::size_t keys = request.key_time_h.size();
      if (keys == 0) {
        const Representation r = representationOf(closest, *member.day);
        keys = std::max<std::size_t>(1, placeKeys(*member.day, r, request.max_error).size());
      }
      const std::size_t channels = isGrey(*member.day->day->sky) ? 1 : 3;
      const Encoding least = request.encoding.value_or(format::kEncodings.back());
      for (Choice& choice : choices_) {
        const std::size_t rows = choice.modes ? choice.modes->set->count() : model::polarIndex(choice.bands, 0);
        choice.least_bytes += keys * format::bytesOfKey(least, rows * channels);
      }
    }
  }

  Representation representationOf(const Choice& choice, const DayValues& day) const {
    if (!choice.modes) return coefficientsOf(day, choice.bands, false);
    const SharedModes& m = *choice.modes;
    return modesOf(day, *m.set, weightsOf(day, *m.set), m.columns, m.rows, choice.bands);
  }

  /// Plans that end with the first member whose budget is not met.
  std::vector<DayPlan> planWith(const Choice& choice, bool all = true) {
    std::vector<DayPlan> plans;
    for (const FamilyMember& member : family_) {
      PlanRequest request = member.request;
      request.bands = choice.bands;
      request.shared = choice.modes;
      if (!choice.modes) request.sh_bands = choice.bands;
      plans.push_back(planDay(*member.day, request, progress_));
      if (!all && !plans.back().met) break;
    }
    return plans;
  }

  void tryOne(const Choice& choice) {
    std::vector<DayPlan> plans = planWith(choice, false);
    std::size_t bytes = 0;
    for (const DayPlan& plan : plans) bytes += plan.bytes;
    if (!plans.back().met || bytes >= bytes_) return;
    bytes_ = bytes;
    best_ = std::move(plans);
  }

  std::span<const FamilyMember> family_;
  const base::Progress& progress_;
  std::deque<ModeSet> sets_;  ///< keeps its addresses
  std::vector<Choice> choices_;
  std::size_t bytes_ = SIZE_MAX;
  std::vector<DayPlan> best_;
};

}  // namespace

std::vector<DayPlan> planFamily(std::span<const FamilyMember> family, const base::Progress& progress) {
  return FamilyPlanner(family, progress).run();
}

}  // namespace welkin::table
