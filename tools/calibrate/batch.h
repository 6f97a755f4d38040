// SPDX-License-Identifier: Apache-2.0
// Photographs to files: one, or the pictures of a folder in parallel, without those that a former run has made.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/profile.h"
#include "sky/base/error.h"
#include "sky/base/progress.h"

namespace welkin::calibrate {

/// What happens to every photograph.
struct Batch {
  PhotoOptions photo;
  std::optional<Profile> profile;  ///< used on photographs, which then need no chart
  std::string format = "exr";      ///< the albedo's ending, as writeAlbedo() knows it
  std::filesystem::path folder;    ///< for all files
  std::filesystem::path parallel;  ///< of one photograph: the same through a parallel polariser; empty for none
};

/// The pictures of a folder by name. Throws Error(file), and Error(content) for a folder without any.
std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder);

/// A photograph and its files' names within the folder.
struct Job {
  std::filesystem::path photo;
  std::string albedo, report, profile, picture;
  std::string specular;  ///< STEM.specular.ENDING, where Batch::parallel is set
};

/// The files of a photograph by itself: STEM.exr, report.json, report.png and profile.json. Throws Error(usage) where
/// one would take the place of the photograph or of another.
Job singleJob(const std::filesystem::path& photo, const Batch& batch);

/// The pictures of a folder by name, with STEM.exr, STEM.report.json, STEM.report.png and STEM.profile.json. Throws
/// Error(file), and Error(content) for a folder without pictures and for two of one name, Error(usage) as singleJob().
std::vector<Job> jobsIn(const std::filesystem::path& folder, const Batch& batch);

struct Made {
  nlohmann::ordered_json report;              ///< also in the file; null where the photograph failed
  std::optional<CalibratedPhoto> calibrated;  ///< without its image; none where a profile was used
  bool up_to_date = false;
};

/// Calibrates one photograph and writes its files, the report last. Where `resume` is set, files of the same input that
/// are as a former run wrote them stay.
Made make(const Job& job, const Batch& batch, bool resume);

struct BatchResult {
  std::vector<Made> made;  ///< in the order of the jobs
  struct Failure {
    std::string photo;
    base::Error error;
  };
  std::vector<Failure> failed;
};

/// Makes all, at most kMostAtOnce at a time, for memory's sake. One that fails does not keep others from their files.
BatchResult makeAll(const std::vector<Job>& jobs, const Batch& batch, bool resume, const base::Progress& progress);
inline constexpr int kMostAtOnce = 4;

}  // namespace welkin::calibrate
