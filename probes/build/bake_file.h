// SPDX-License-Identifier: Apache-2.0
// The bake of a file, a sky or a level, into a folder: from what is asked for to the report of what was made.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "probes/build/read_level.h"
#include "probes/build/shard.h"
#include "probes/build/subject.h"
#include "sky/bake/certify.h"

namespace welkin::build {

/// What is asked for. Empty paths and texts: not given.
struct BakeRequest {
  std::filesystem::path file;       ///< a sky file or a level file
  std::filesystem::path folder;     ///< of the outputs; made when missing
  std::filesystem::path report;     ///< of the report, in place of the folder's report.json
  std::filesystem::path depfile;    ///< of the inputs as a make rule
  std::optional<double> max_error;  ///< the budget, in place of the sky file's, in its domain
  bake::Certify certify = bake::Certify::fast;
  std::optional<Shard> shard;  ///< the sectors of this shard alone; shard 0 bakes the sky as well
  std::string sectors;         ///< these alone, as parseSectors takes them
  bool force = false;          ///< bake what is up to date as well
};

/// What was read for a request: the sky, under its budget, and the level where it is one.
struct BakeInput {
  Subject subject;
  std::optional<LevelInput> level;
};

/// Reads the request's file. Throws Error: usage for a budget outside its domain, or sectors asked of a sky.
BakeInput readInput(const BakeRequest& request, const base::Progress& progress);

/// Bakes what is out of date, measures it, and writes report and timing. Returns the report. Throws Error; files that
/// were finished before stay, and every one is whole.
nlohmann::ordered_json bakeFile(const BakeRequest& request, const base::Progress& progress);

/// A report as text. A file name that is not UTF-8 is shown with replacement characters.
std::string reportText(const nlohmann::ordered_json& json);

}  // namespace welkin::build
