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
constexpr std::uint32_t kSearchVersion = 1;

/// Points of one sector, for its part of the level's error. The seed is neither the fit's nor the certificate's.
constexpr std::uint64_t kSeed = 0xb06e7;
constexpr std::size_t kSurfacePoints = 96, kAirPoints = 48, kPaths = 128;

/// Mean squares of a sector's error by its own probes, and the areas that they are of.
struct OwnError {
  double surface = 0.0, air = 0.0;
  double surface_m2 = 0.0, air_m2 = 0.0;
};

double errorArea(const OwnError& e) {
  return e.surface * e.surface_m2 + e.air * e.air_m2;
}

/// Closer probes must take at least this share of the level's squared error for as much of its probes.
constexpr double kLeastGain = 0.1;

/// A sector of the search.
struct Trial {
  std::size_t next = 0;  ///< of kSpreads, to be tried
  double spread = kSpreads[0];
  std::optional<sectors::SectorFile> file;
  OwnError error;

  bool canTry() const { return next < kSpreads.size() && !(file && file->probes.probes() >= geometry::kMostProbes); }
};

class Search {
 public:
  Search(const LevelBake& level, const model::Sky& sky, const base::Progress& progress)
      : level_(level), sky_(sky), tracer_(level.surfaces()), progress_(progress), trial_(level.sectors().size()) {
    for (std::size_t i = 0; i < trial_.size(); ++i) tryNext(i);
  }

  SurfaceChoice within(double max_error) {
    SurfaceChoice choice;
    // A sector's own error is of few points and without its neighbours' probes, so it only tells when to look again.
    double scale = 0.0;
    for (;;) {
      const double own = ownError();
      const auto next = mostErrorAProbe();
      if (next && scale * own > max_error) {
        tryNext(*next);
        continue;
      }
      choice.error = certified();
      choice.kept = choice.error <= max_error;
      if (choice.kept || !next) break;
      scale = choice.error / own;
    }
    for (Trial& t : trial_) {
      choice.spread.push_back(t.spread);
      choice.file.push_back(std::move(*t.file));
    }
    return choice;
  }

 private:
  /// Bakes a sector with its next spread, and keeps the result where it pays.
  void tryNext(std::size_t i) {
    Trial& t = trial_[i];
    const double spread = kSpreads[t.next++];
    sectors::SectorFile file = level_.bake(level_.sectors()[i], progress_, spread);
    const OwnError error = errorOf(file);
    if (t.file && !pays(t, file, error)) return;
    t.spread = spread;
    t.file = std::move(file);
    t.error = error;
  }

  /// Whether the level's error falls by enough for the probes that a sector would get.
  bool pays(const Trial& now, const sectors::SectorFile& file, const OwnError& error) const {
    double all = 0.0, probes = 0.0;
    for (const Trial& t : trial_) {
      all += errorArea(t.error);
      probes += t.file ? static_cast<double>(t.file->probes.probes()) : 0.0;
    }
    const double less = (errorArea(now.error) - errorArea(error)) / all;
    const double more =
        (static_cast<double>(file.probes.probes()) - static_cast<double>(now.file->probes.probes())) / probes;
    return less > 0.0 && less >= kLeastGain * more;
  }

  OwnError errorOf(const sectors::SectorFile& file) const {
    certify::CertifySettings settings;
    settings.surface_points = kSurfacePoints;
    settings.air_points = kAirPoints;
    settings.paths = kPaths;
    settings.bounces = level_.bounces();
    settings.seed = kSeed;
    const auto found = certify::certifyLevel(tracer_, sky_, {file}, settings, progress_);
    const auto square = [](const certify::ErrorsOf& e) { return e.total.rms * e.total.rms; };
    return {square(found.surface), square(found.air), found.surface_m2, found.air_m2};
  }

  /// The larger error of surfaces and air, from the sectors' own.
  double ownError() const {
    double surface = 0.0, air = 0.0, surface_m2 = 0.0, air_m2 = 0.0;
    for (const Trial& t : trial_) {
      surface += t.error.surface * t.error.surface_m2;
      air += t.error.air * t.error.air_m2;
      surface_m2 += t.error.surface_m2;
      air_m2 += t.error.air_m2;
    }
    return std::sqrt(std::max(surface_m2 > 0.0 ? surface / surface_m2 : 0.0, air_m2 > 0.0 ? air / air_m2 : 0.0));
  }

  /// The sector that may have closer probes and has the most error for each that it has; nothing if none may.
  std::optional<std::size_t> mostErrorAProbe() const {
    std::optional<std::size_t> found;
    double most = 0.0;
    for (std::size_t i = 0; i < trial_.size(); ++i) {
      const Trial& t = trial_[i];
      const double a_probe =
          errorArea(t.error) / static_cast<double>(std::max<std::size_t>(t.file->probes.probes(), 1));
      if (!t.canTry() || a_probe <= most) continue;
      most = a_probe;
      found = i;
    }
    return found;
  }

  double certified() const {
    std::vector<sectors::SectorFile> files;
    std::size_t probes = 0;
    for (const Trial& t : trial_) {
      files.push_back(*t.file);
      probes += t.file->probes.probes();
    }
    const auto found =
        certify::certifyLevel(tracer_, sky_, files, certifySettings(level_, probes, bake::Certify::fast), progress_);
    return std::max(found.surface.total.rms, found.air.total.rms);
  }

  const LevelBake& level_;
  const model::Sky& sky_;
  geometry::Tracer tracer_;
  base::Progress progress_;
  std::vector<Trial> trial_;  // by sector
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
