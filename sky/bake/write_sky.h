// SPDX-License-Identifier: Apache-2.0
// A planned sky as the runtime opens it, its certificate, and its files.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "sky/bake/certify_blends.h"
#include "sky/bake/sky_plan.h"
#include "sky/bake/sky_record.h"
#include "sky/bake/stopwatch.h"

namespace welkin::bake {

/// The file of a plan, without cubemaps, opened by the runtime.
class OpenedPlan {
 public:
  /// Throws Error(internal) where the runtime refuses it.
  OpenedPlan(const SkyFile& file, const SkyPlan& plan);
  const WelkinSky* get() const { return sky_.get(); }

 private:
  std::vector<std::byte> bytes_;
  std::unique_ptr<WelkinSky, void (*)(WelkinSky*)> sky_;
};

/// A plan, and what was measured of it; none without --certify.
struct Certified {
  SkyPlan plan;
  std::optional<table::Certificate> certificate;
  nlohmann::ordered_json blends = {};  ///< with each other sky of the family, for the report; null for a sky alone
};

/// The certificate of an opened plan.
table::Certificate measure(const OpenedPlan& opened, const SkyFile& file, const SkyPlan& plan, double brightest,
                           Certify how, const base::Progress& progress);

/// Makes and measures the cubemaps, and writes cubemaps, record and sky into `folder`. Returns what was made, for
/// record and report; adds seconds to `timing`. Throws Error.
nlohmann::ordered_json writeSky(const SkyFile& file, Certified certified, const std::filesystem::path& folder,
                                const SkyRequest& request, const base::Progress& progress, Stopwatch& watch,
                                nlohmann::ordered_json& timing);

/// The part of a report that is about one sky: its settings, target, and what was made, with all warnings.
nlohmann::ordered_json skyReport(const SkyFile& file, nlohmann::ordered_json made);

/// The files that were read, for the report.
nlohmann::ordered_json inputsJson(const std::vector<Input>& inputs);

}  // namespace welkin::bake
