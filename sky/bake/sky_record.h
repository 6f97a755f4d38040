// SPDX-License-Identifier: Apache-2.0
// The record of a sky's bake, DIR/NAME.json: what it was asked for and what it made. By it the next bake sees that
// there is nothing to do, and reports the same. It is no part of NAME.welkin, which games load. NAME is "sky", but for
// a sky of a family.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "sky/bake/certify.h"
#include "sky/bake/sky_file.h"

namespace welkin::bake {

/// Version of the method. It grows by one whenever the same input gives other bytes, as tests/golden/same_bytes.txt
/// shows, or another report.
inline constexpr int kSkyBakeVersion = 4;

/// The options of a sky's bake.
struct SkyRequest {
  Certify certify = Certify::fast;
  bool force = false;  ///< bake what is up to date as well
  /// Told of a plan's warnings before the bake that they warn of. They are in the report as well.
  std::function<void(const std::string&)> warn = {};
};

/// The state of a sky's file before a bake.
struct SkyState {
  std::string stale;            ///< why it is to be baked; empty: it is up to date
  nlohmann::ordered_json made;  ///< when it is up to date: what recordText was told of it
};

/// Compares NAME.welkin, its inputs and checksum, what its bake was asked for, and every output that the record has the
/// checksum of, with what a bake into `folder` (none: a new one) of `file` would be. Throws Error(file) for what is
/// there and cannot be read.
SkyState skyState(const std::filesystem::path& folder, const SkyFile& file, Certify certify);

/// The outputs that the record of a sky of a folder lists; null without the file. Throws Error: content where it is
/// damaged, or where an output that it lists is another file; file where one is missing.
nlohmann::ordered_json checkedRecord(const std::filesystem::path& folder, const std::string& sky = "sky");

/// The names of the skies of a folder that have a record, sorted.
std::vector<std::string> recordedSkies(const std::filesystem::path& folder);

/// The content of NAME.json, with a checksum of itself. `made` has "outputs": of each "file" and "xxh3_128".
std::string recordText(const SkyFile& file, Certify certify, const nlohmann::ordered_json& made);

}  // namespace welkin::bake
