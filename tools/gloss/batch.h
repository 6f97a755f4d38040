// SPDX-License-Identifier: Apache-2.0
// A folder of textures: which ones there are, and which ones a former run has made already.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gloss/write_gloss.h"
#include "sky/base/error.h"

namespace welkin::gloss {

/// The normal maps of a folder by name: pictures whose names end in _normal, _nrm or _n, in any case. A picture of the
/// same name with _gloss or _roughness in that place belongs to it; one without takes the gloss of `common`. Throws
/// Error(content) for a folder without normal maps, two that give files of one name, and one without any gloss.
std::vector<Request> texturesIn(const std::filesystem::path& folder, const Request& common);

/// The files that a request reads.
std::vector<std::filesystem::path> inputsOf(const Request& request);

/// The report of one texture, and whether its files were up to date.
struct Made {
  nlohmann::ordered_json report;
  bool up_to_date = false;
};

/// Reports of a former run by the normal map's name, from the text of report.json; none from anything else.
class FormerReports {
 public:
  explicit FormerReports(std::string_view text);

  /// writeGloss(), unless the former run had the same inputs and options and its files are there as it wrote them.
  Made make(const Request& request, const std::filesystem::path& folder, const base::Progress& progress) const;

 private:
  std::vector<nlohmann::ordered_json> textures_;
};

/// Makes all textures in parallel. One that fails does not keep the others from their files: the report names it.
/// report.json's content is one texture's report, or for a folder {"textures", "failed"}.
struct BatchResult {
  std::vector<Made> made;  ///< in the order of the requests; without a report where it failed
  struct Failure {
    std::string normal;
    base::Error error;
  };
  std::vector<Failure> failed;
};
BatchResult makeAll(const std::vector<Request>& requests, const std::filesystem::path& folder,
                    const FormerReports& former, const base::Progress& progress);

}  // namespace welkin::gloss
