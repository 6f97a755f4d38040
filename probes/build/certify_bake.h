// SPDX-License-Identifier: Apache-2.0
// The certificate of a baked level: its error on surfaces and in the air, for the report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "probes/build/level_bake.h"
#include "probes/certify/level_certificate.h"
#include "sky/bake/certify.h"

namespace welkin::build {

/// How a level with so many probes is measured.
certify::CertifySettings certifySettings(const LevelBake& level, std::size_t probes, bake::Certify how);

/// Measures the whole level in a folder and adds the result to the report as "surfaces". `none` adds nothing. Where the
/// folder's report.json has the certificate of the same files already, that is taken. Throws Error.
void certifyBake(const LevelBake& level, const model::Sky& sky, const std::filesystem::path& folder,
                 const sectors::LevelIndex& index, bake::Certify how, const base::Progress& progress,
                 nlohmann::ordered_json& report);

/// A sentence for each part of the light that would have the smaller error if it were left out, beyond the confidence
/// interval. certifyBake() adds them to the report's warnings as "worse-than-nothing".
std::vector<std::string> worseThanNothing(const nlohmann::ordered_json& certificate);

/// The certificate in a folder's report.json, as report["surfaces"]; nothing where there is none of the index's files.
std::optional<nlohmann::ordered_json> certificateIn(const std::filesystem::path& folder,
                                                    const sectors::LevelIndex& index);

}  // namespace welkin::build
