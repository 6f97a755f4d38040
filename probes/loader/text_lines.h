// SPDX-License-Identifier: Apache-2.0
// Splits text into lines of words, as OBJ and MTL files have them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace welkin::loader {

/// Reads a text line by line. Comments from # on are cut, and a \ at the end joins the next line.
class TextLines {
 public:
  /// `text` must outlive the object; `file` is named in messages.
  TextLines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

  /// Moves to the next line that has a word; false at the end.
  bool next();

  /// Words of the line, at least one. They stay valid until next().
  const std::vector<std::string_view>& words() const { return words_; }
  /// The line after its first word, without space around it.
  std::string_view rest() const;

  /// Word `i` as a number; nan and inf count as numbers. Throws Error(content) naming file and line, as refuse() does.
  double number(std::size_t i) const;
  [[noreturn]] void refuse(const std::string& why) const;

  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::string_view rest_;
  std::string line_;
  std::vector<std::string_view> words_;
  std::size_t line_number_ = 0;
  std::size_t lines_joined_ = 0;
};

/// Parses a word that is a whole number; false for any other word.
bool parseWhole(std::string_view word, int& value);

}  // namespace welkin::loader
