// SPDX-License-Identifier: Apache-2.0
// level.toml while it is edited: its text, what is saved, and the journal of what is not.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "view/level_text.h"

namespace welkin::view {

class LevelEdits {
 public:
  /// Reads the file, and the journal beside it, LEVEL.toml.unsaved, that an earlier run has left. A journal that says
  /// what the file says is removed. Throws Error.
  explicit LevelEdits(std::filesystem::path level);

  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return text_; }
  const HandPlaced& placed() const { return placed_; }
  bool unsaved() const { return text_ != saved_; }
  /// The edits of an earlier run wait for recover() or discard().
  bool offers() const { return offered_.has_value(); }

  /// Replaces the text and writes the journal. Throws Error(content) while the edits of an earlier run wait, and where
  /// the text is not TOML; Error(file) where the journal cannot be written, after the text is replaced.
  void set(const std::string& text);
  /// Writes the file whole and removes the journal. Throws Error(content) where another program has changed the file.
  void save();
  /// Takes the edits of the earlier run.
  void recover();
  /// Drops the edits of the earlier run, or else what is not saved, and reads the file anew.
  void discard();

 private:
  std::filesystem::path journal() const;
  std::string read(const std::filesystem::path& file) const;

  std::filesystem::path path_;
  std::string text_, saved_;
  HandPlaced placed_;
  std::optional<std::string> offered_;
};

}  // namespace welkin::view
