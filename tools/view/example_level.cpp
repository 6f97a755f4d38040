// SPDX-License-Identifier: Apache-2.0
#include "view/example_level.h"

#include <fmt/format.h>
#include <welkin/welkin.h>

#include <system_error>

#include "probes/build/bake_file.h"
#include "probes/build/level_files.h"
#include "probes/build/sector_bake.h"
#include "sky/base/error.h"
#include "view/user_folder.h"

namespace welkin::view {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExample = "examples/island/level.toml";

}  // namespace

fs::path exampleLevel() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (fs::path folder = program.parent_path();; folder = folder.parent_path()) {
    for (const fs::path& file : {folder / kExample, folder / "share/welkin" / kExample})
      if (fs::is_regular_file(file, error)) return file;
    if (folder == folder.parent_path()) break;
  }
  throw base::Error(base::ExitStatus::file,
                    fmt::format("no level is named, and {} is in no folder above {}; welkin view LEVEL_DIR shows a "
                                "level that welkin bake has made",
                                kExample, program.parent_path().string()));
}

fs::path bakedExample(const base::Progress& progress) {
  const fs::path level = exampleLevel();
  const fs::path cache = cacheFolder();
  if (cache.empty())
    throw base::Error(base::ExitStatus::file,
                      "no level is named, and there is no folder to bake the example in: set XDG_CACHE_HOME or HOME");
  const fs::path folder = cache / fmt::format("island-{}.{}.{}-{}", WELKIN_VERSION_MAJOR, WELKIN_VERSION_MINOR,
                                              WELKIN_VERSION_PATCH, build::kBakeVersion);
  std::error_code error;
  if (build::isLevelFolder(folder) && fs::is_regular_file(folder / "report.json", error)) return folder;
  build::BakeRequest request;
  request.file = level;
  request.folder = folder;
  request.cubemap_error = 0.0;  // the viewer draws the dome from the sky's formulas
  request.certify = bake::Certify::none;
  build::bakeFile(request, progress);
  return folder;
}

}  // namespace welkin::view
