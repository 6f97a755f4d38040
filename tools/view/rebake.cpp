// SPDX-License-Identifier: Apache-2.0
#include "view/rebake.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <system_error>

#include "probes/build/bake_file.h"
#include "probes/build/level_files.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"

namespace welkin::view {
namespace {

namespace fs = std::filesystem;

fs::path copyOf(const fs::path& folder) {
  fs::path whole = fs::absolute(folder).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();
  whole += ".rebake";
  return whole;
}

/// Files in the order in which they are taken: sectors first, then the index, the report last.
std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> first, last;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name == ".welkin.lock") continue;
    const bool is_last = name == "level.welkin" || name == "report.json";
    (is_last ? last : first).push_back(entry.path().lexically_relative(folder));
  }
  std::sort(first.begin(), first.end());
  std::sort(last.begin(), last.end());
  first.insert(first.end(), last.begin(), last.end());
  return first;
}

}  // namespace

Rebake::Rebake(fs::path level, fs::path folder, std::string sectors)
    : level_(std::move(level)), folder_(std::move(folder)), copy_(copyOf(folder_)) {
  try {
    fs::remove_all(copy_);
    fs::copy(folder_, copy_, fs::copy_options::recursive);
  } catch (const fs::filesystem_error& error) {
    throw base::Error(base::ExitStatus::file, fmt::format("rebake: {}", error.what()));
  }
  thread_ = std::thread([this, names = std::move(sectors)] { run(names); });
}

Rebake::~Rebake() {
  cancel();
  thread_.join();
  std::error_code error;
  fs::remove_all(copy_, error);
}

RebakeStatus Rebake::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void Rebake::run(const std::string& sectors) {
  build::BakeRequest request;
  request.file = level_;
  request.folder = copy_;
  request.sectors = sectors;
  request.certify = bake::Certify::none;
  std::error_code none;
  if (!fs::is_directory(copy_ / "cubemaps", none)) request.cubemap_error = 0.0;  // as it was baked
  const base::Progress progress([this](const base::Progress::Stage& stage, base::Progress::Event event) {
    const std::lock_guard lock(mutex_);
    const bool of_sector = stage.around() != nullptr && stage.around()->name() == "sectors";
    if (!of_sector && stage.around() != nullptr && stage.around()->name().empty()) {
      status_.stage = stage.name();
      status_.done = stage.done();
      status_.total = stage.total();
    }
    if (of_sector && event == base::Progress::Event::ended && !cancelled_ && std::uncaught_exceptions() == 0)
      if (const auto id = geometry::sectorOf(stage.name())) status_.finished.push_back(*id);
    return !cancelled_.load();
  });
  RebakeState state = RebakeState::done;
  std::string message;
  try {
    const nlohmann::ordered_json report = build::bakeFile(request, progress);
    for (const auto& warning : report["warnings"])
      if (warning["id"] == "no-index")
        throw base::Error(base::ExitStatus::content, warning["message"].get<std::string>());
  } catch (const base::Error& error) {
    state = error.status() == base::ExitStatus::interrupted ? RebakeState::cancelled : RebakeState::failed;
    message = error.what();
  } catch (const std::exception& error) {
    state = RebakeState::failed;
    message = error.what();
  }
  const std::lock_guard lock(mutex_);
  status_.state = state;
  if (state == RebakeState::failed) status_.message = message;
}

void Rebake::take() {
  try {
    const base::FolderLock lock(folder_);
    for (const fs::path& file : filesOf(copy_)) {
      base::makeFolder((folder_ / file).parent_path());
      base::writeFile(folder_ / file, base::readFile(copy_ / file));
    }
    build::removeOtherSectors(folder_, build::readIndex(build::indexPath(folder_)));
  } catch (const fs::filesystem_error& error) {
    throw base::Error(base::ExitStatus::file, fmt::format("rebake: {}", error.what()));
  }
}

}  // namespace welkin::view
