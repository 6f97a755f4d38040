// SPDX-License-Identifier: Apache-2.0
#include "probes/build/surface_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "probes/build/certify_bake.h"
#include "probes/build/merged_report.h"
#include "probes/certify/level_certificate.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBudgetKey = "surface_budget";

/// Version of the search; it grows when the same level gets other spreads.
constexpr std::uint32_t kSearchVersion = 2;

/// Points of one sector, for its part of the level's error. The seed is neither the fit's nor the certificate's.
constexpr std::uint64_t kSeed = 0xb06e7;
constexpr std::size_t kSurfacePoints = 96, kAirPoints = 48, kPaths = 128;

/// Prices of error in bytes that a search tries, by bisection of their exponent.
constexpr int kPrices = 8;
constexpr double kLowestExponent = -6.0, kHighestExponent = 6.0;

/// A sector that was baked with one spread.
struct Trial {
  sectors::SectorFile file;
  double bytes = 0.0;
  double error_m2 = 0.0;  ///< mean square error by its own probes, times area: of its surfaces and of the air
};

class Search {
 public:
  Search(const LevelBake& level, const model::Sky& sky, const base::Progress& progress)
      : level_(level), sky_(sky), tracer_(level.surfaces()), progress_(progress), trial_(level.sectors().size()) {}

  SurfaceChoice within(double max_error) {
    Tried best;
    for (std::size_t k = 0; k < kSpreads.size(); ++k) {
      bakeAll(k);
      const Tried tried = certified(std::vector<std::size_t>(trial_.size(), k));
      if (best.spread.empty() || tried.error < best.error) best = tried;
      if (tried.error <= max_error) {
        best = cheapest(tried, max_error);
        break;
      }
      if (isFull(k)) break;
    }
    SurfaceChoice choice;
    choice.error = best.error;
    choice.kept = best.error <= max_error;
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      choice.spread.push_back(kSpreads[best.spread[i]]);
      choice.file.push_back(std::move(trial_[i][best.spread[i]].file));
    }
    return choice;
  }

 private:
  /// A spread for each sector, and the level's error with these.
  struct Tried {
    std::vector<std::size_t> spread;  ///< of kSpreads
    double error = 0.0;
    double bytes = 0.0;
  };

  void bakeAll(std::size_t k) {
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      Trial trial{level_.bake(level_.sectors()[i], progress_, kSpreads[k]), 0.0, 0.0};
      trial.bytes = static_cast<double>(sectors::encodeSector(trial.file).size());
      trial.error_m2 = errorOf(trial.file);
      trial_[i].push_back(std::move(trial));
    }
  }

  /// Whether no sector can hold more probes.
  bool isFull(std::size_t k) const {
    return std::all_of(trial_.begin(), trial_.end(),
                       [&](const std::vector<Trial>& t) { return t[k].file.probes.probes() >= geometry::kMostProbes; });
  }

  double errorOf(const sectors::SectorFile& file) const {
    const certify::CertifySettings settings{kSurfacePoints, kAirPoints, kPaths, level_.bounces(), false, kSeed};
    const auto found = certify::certifyLevel(tracer_, sky_, {file}, settings, progress_);
    return std::pow(found.surface.total.rms, 2) * found.surface_m2 + std::pow(found.air.total.rms, 2) * found.air_m2;
  }

  Tried certified(std::vector<std::size_t> spread) const {
    Tried tried{std::move(spread), 0.0, 0.0};
    std::vector<sectors::SectorFile> files;
    std::size_t probes = 0;
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      const Trial& t = trial_[i][tried.spread[i]];
      files.push_back(t.file);
      probes += t.file.probes.probes();
      tried.bytes += t.bytes;
    }
    const auto found =
        certify::certifyLevel(tracer_, sky_, files, certifySettings(level_, probes, bake::Certify::fast), progress_);
    tried.error = std::max(found.surface.total.rms, found.air.total.rms);
    return tried;
  }

  /// The spreads of fewest bytes, where error has a price: a Lagrange multiplier (Everett 1963). Bytes and errors count
  /// as shares of the level's.
  std::vector<std::size_t> spreadsAt(double price, const Tried& all) const {
    double error_m2 = 0.0;
    for (std::size_t i = 0; i < trial_.size(); ++i) error_m2 += trial_[i][all.spread[i]].error_m2;
    std::vector<std::size_t> spread;
    for (const std::vector<Trial>& tries : trial_) {
      const auto cost = [&](const Trial& t) {
        return t.bytes / all.bytes + (error_m2 > 0.0 ? price * t.error_m2 / error_m2 : 0.0);
      };
      const auto least = std::min_element(tries.begin(), tries.end(),
                                          [&](const Trial& a, const Trial& b) { return cost(a) < cost(b); });
      spread.push_back(static_cast<std::size_t>(least - tries.begin()));
    }
    return spread;
  }

  /// Of `kept`, which is within the budget, and of spreads that differ by sector, the one of fewest bytes within it.
  Tried cheapest(const Tried& kept, double max_error) const {
    Tried best = kept;
    double low = kLowestExponent, high = kHighestExponent;
    for (int i = 0; i < kPrices; ++i) {
      const double middle = 0.5 * (low + high);
      const Tried tried = certified(spreadsAt(std::exp2(middle), kept));
      if (tried.error <= max_error && tried.bytes < best.bytes) best = tried;
      (tried.error <= max_error ? high : low) = middle;
    }
    return best;
  }

  const LevelBake& level_;
  const model::Sky& sky_;
  geometry::Tracer tracer_;
  base::Progress progress_;
  std::vector<std::vector<Trial>> trial_;  // by sector, then spread
};

/// What a choice depends on.
std::string subjectOfSearch(const LevelBake& level, const bake::SkyFile& sky) {
  base::Hasher hasher;
  hasher.add(kSearchVersion);
  hasher.add(kBakeVersion);
  hasher.add(level.budget().value_or(0.0));
  for (const bake::Input& input : sky.inputs) {
    hasher.add(input.xxh3_low);
    hasher.add(input.xxh3_high);
  }
  hasher.add(level.geometryHash());
  hasher.add(std::string_view(level.index().settings));
  return textOf(hasher.digest());
}

}  // namespace

std::optional<SurfaceChoice> earlierChoice(const LevelBake& level, const bake::SkyFile& sky,
                                           const std::filesystem::path& folder) {
  const auto report = earlierReport(folder);
  static const Json kForm = {{kBudgetKey, {{"of", ""}, {"error", 0.5}, {"kept", true}, {"spread", Json::object()}}}};
  if (!report || !base::hasForm(*report, kForm)) return std::nullopt;
  const Json& found = (*report)[kBudgetKey];
  SurfaceChoice choice{{}, found["error"], found["kept"], found["of"]};
  if (choice.of != subjectOfSearch(level, sky)) return std::nullopt;
  for (const geometry::SectorId sector : level.sectors()) {
    const auto spread = found["spread"].find(nameOf(sector));
    if (spread == found["spread"].end() || !spread->is_number()) return std::nullopt;
    choice.spread.push_back(*spread);
    if (std::find(kSpreads.begin(), kSpreads.end(), choice.spread.back()) == kSpreads.end()) return std::nullopt;
  }
  return choice;
}

SurfaceChoice chooseSpreads(const LevelBake& level, const bake::SkyFile& sky, bool part_alone,
                            const base::Progress& progress) {
  if (part_alone)
    throw base::Error(base::ExitStatus::usage,
                      "--shard, --sectors: [bake] max_surface_error is of the whole level; bake it without them first");
  SurfaceChoice choice = Search(level, sky.sky, progress.stage("budget of surfaces", 0)).within(*level.surfaceBudget());
  choice.of = subjectOfSearch(level, sky);
  return choice;
}

Json choiceJson(const LevelBake& level, const SurfaceChoice& choice) {
  Json spread = Json::object();
  for (std::size_t i = 0; i < choice.spread.size(); ++i) spread[nameOf(level.sectors()[i])] = choice.spread[i];
  return {{"max_error", *level.surfaceBudget()},
          {"error", choice.error},
          {"kept", choice.kept},
          {"of", choice.of},
          {"spread", spread}};
}

void requireKept(const std::filesystem::path& file, const LevelBake& level, const Json& report) {
  if (!report.contains("surfaces")) return;
  const auto rms = [&](const char* where) { return report["surfaces"][where]["total"]["rms"].get<double>(); };
  if (std::max(rms("surface"), rms("air")) <= *level.surfaceBudget()) return;
  std::size_t bytes = 0;
  for (const Json& sector : report["sectors"]) bytes += sector["bytes"].get<std::size_t>();
  throw base::Error(
      base::ExitStatus::content,
      fmt::format("{}: [bake] max_surface_error: {:g} cannot be kept by closer probes; the best is {:.3g} "
                  "on surfaces and {:.3g} in the air, for {} bytes of sectors, and was written",
                  file.string(), *level.surfaceBudget(), rms("surface"), rms("air"), bytes));
}

}  // namespace welkin::build
