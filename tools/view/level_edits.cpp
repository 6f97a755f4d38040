// SPDX-License-Identifier: Apache-2.0
#include "view/level_edits.h"

#include <fmt/format.h>

#include <system_error>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/toml_file.h"

namespace welkin::view {

namespace fs = std::filesystem;

LevelEdits::LevelEdits(fs::path level) : path_(std::move(level)) {
  text_ = saved_ = read(path_);
  placed_ = handPlacedOf(text_);
  std::error_code error;
  if (!fs::is_regular_file(journal(), error)) return;
  offered_ = read(journal());
  if (*offered_ != saved_) return;
  offered_.reset();
  fs::remove(journal(), error);
}

fs::path LevelEdits::journal() const {
  fs::path file = path_;
  file += ".unsaved";
  return file;
}

std::string LevelEdits::read(const fs::path& file) const {
  const std::vector<std::byte> bytes = base::readFile(file, base::kLargestTomlFile);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void LevelEdits::set(const std::string& text) {
  if (offered_)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{} holds edits of an earlier run: `recover` takes them, `discard` drops them",
                                  journal().string()));
  HandPlaced placed = handPlacedOf(text);
  placed_ = std::move(placed);
  text_ = text;
  std::error_code error;
  if (unsaved())
    base::writeFile(journal(), text_);
  else
    fs::remove(journal(), error);
}

void LevelEdits::save() {
  if (!unsaved()) return;
  if (read(path_) != saved_)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{} has been changed by another program since it was read: `discard` reads it anew",
                                  path_.string()));
  base::writeFile(path_, text_);
  saved_ = text_;
  std::error_code error;
  fs::remove(journal(), error);
}

void LevelEdits::recover() {
  if (!offered_) throw base::Error(base::ExitStatus::content, "recover: no edits of an earlier run are there");
  HandPlaced placed = handPlacedOf(*offered_);
  placed_ = std::move(placed);
  text_ = *offered_;
  offered_.reset();
}

void LevelEdits::discard() {
  std::string text = read(path_);
  HandPlaced placed = handPlacedOf(text);
  placed_ = std::move(placed);
  saved_ = text_ = std::move(text);
  offered_.reset();
  std::error_code error;
  fs::remove(journal(), error);
}

}  // namespace welkin::view
