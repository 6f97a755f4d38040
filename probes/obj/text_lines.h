// SPDX-License-Identifier: Apache-2.0
// Splits text into lines of words, as OBJ and MTL files have them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace welkin::obj {

/// Reads a text line by line. Lines end as Unix, Windows or the old Mac OS end them. A \ at the end joins the next
/// line. The mark that some programs write before UTF-8 is skipped, at the start of any line, as files may be joined.
class TextLines {
 public:
  /// `text` must outlive the object; `file` is named in messages. Throws Error(content) for UTF-16, UTF-32 and binary
  /// files, as refuse() does.
  TextLines(std::string file, std::string_view text);

  /// Moves to the next line that has a word; false at the end.
  bool next();

  /// Words of the line up to its comment, at least one. They stay valid until next().
  const std::vector<std::string_view>& words() const { return words_; }
  /// First word in lower case; exporters do not agree on case.
  std::string keyword() const;
  /// Words from the i-th on, as one name without the space and the quotes around it. A # is part of a name: 3ds Max
  /// numbers materials so. withoutComment() gives the other reading.
  std::string_view nameFrom(std::size_t i) const;
  /// Number of the line, from 1; of the first one if several are joined.
  std::size_t lineNumber() const { return line_number_ + 1; }

  /// Word `i` as a number; nan and inf count as numbers. Throws Error(content) naming file and line, as refuse() does.
  double number(std::size_t i) const;
  [[noreturn]] void refuse(const std::string& why) const;

  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::string_view rest_;
  std::string line_;
  std::vector<std::string_view> words_;  // of line_ up to its comment
  std::size_t line_number_ = 0;
  std::size_t lines_joined_ = 0;
};

/// ASCII letters in lower case.
std::string lowerCase(std::string_view word);

/// A name up to its first # after space; all of it if there is none.
std::string_view withoutComment(std::string_view name);

/// Parses a word that is a whole number; false for any other word.
bool parseWhole(std::string_view word, int& value);

}  // namespace welkin::obj
