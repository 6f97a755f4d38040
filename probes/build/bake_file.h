// SPDX-License-Identifier: Apache-2.0
// Bakes a file, a sky or a level, into a folder, and reports the result.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "probes/build/shard.h"
#include "probes/build/subject.h"
#include "probes/build/surface_budget.h"
#include "sky/bake/certify.h"

namespace welkin::build {

/// Options of a bake. An empty path or text stands for none.
struct BakeRequest {
  std::filesystem::path file;                    ///< a sky file or a level file
  std::vector<std::filesystem::path> more = {};  ///< further sky files, which share their modes with the first
  std::filesystem::path folder;                  ///< of the outputs; made when missing
  std::filesystem::path report;                  ///< of the report, in place of the folder's report.json
  std::filesystem::path depfile;                 ///< of the inputs as a make rule
  std::optional<double> max_error;               ///< the budget, in place of the sky file's, in its domain
  /// The budget of the cubemaps, in place of the sky file's settings of them, in its domain; 0: no cubemaps.
  std::optional<double> cubemap_error;
  std::optional<double> max_surface_error;  ///< of a level, in place of its own, in its domain
  std::string target;  ///< the reader of the ambient light, a name of bake::kTargets, in place of the sky file's
  bake::Certify certify = bake::Certify::fast;
  std::optional<Shard> shard;  ///< the sectors of this shard alone; shard 0 bakes the sky as well
  std::string sectors;         ///< these alone, as parseSectors takes them
  bool force = false;          ///< bake what is up to date as well
  std::function<void(const std::string&)> warn = {};  ///< of bake::SkyRequest
};

/// The input of a request as it was read.
struct BakeInput {
  bake::SkyFile sky;                    ///< under the request's budget
  std::vector<bake::SkyFile> more;      ///< further skies of its family, likewise
  std::vector<bake::Input> inputs;      ///< the files of which the skies and the sectors are made
  std::optional<LevelBake> level;       ///< with the spreads of the choice, if there is one
  std::optional<SurfaceChoice> choice;  ///< of the bake that is in the folder, where it is of the same level
};

/// All skies of an input: one, or a family.
std::vector<bake::SkyFile> skiesOf(const BakeInput& read);

/// Reads the request's file. Throws Error: usage for a budget outside its domain, or sectors asked of a sky.
BakeInput readInput(const BakeRequest& request, const base::Progress& progress);

/// Bakes what is out of date, measures it, and writes report and timing. Returns the report. Throws Error: of status
/// content after all is written where a certificate of surfaces is above its budget; of status
/// file while another bake has the folder or the shard; files that were finished before stay, and every one is whole. A
/// folder that may not be written gets no timing, and no error where all is up to date.
nlohmann::ordered_json bakeFile(const BakeRequest& request, const base::Progress& progress);

/// A report as text. A file name that is not UTF-8 is shown with replacement characters.
std::string reportText(const nlohmann::ordered_json& json);

}  // namespace welkin::build
