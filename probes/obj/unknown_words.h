// SPDX-License-Identifier: Apache-2.0
// Keywords of a text file that are not read, for one warning.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "sky/base/message.h"

namespace welkin::obj {

class UnknownWords {
 public:
  void add(std::string_view word, std::size_t line) {
    for (const Word& known : words_)
      if (known.word == word) return;
    if (words_.size() < kMostNamed)
      words_.push_back({std::string(word), line});
    else
      others_ = true;
  }

  /// "word (line 3), other (line 5)": each word with its first line, the first eight of them. Empty if there is none.
  std::string text() const {
    std::string text;
    for (const Word& w : words_)
      text += fmt::format("{}{} (line {})", text.empty() ? "" : ", ", base::shortened(w.word, 40), w.line);
    return others_ ? text + " and others" : text;
  }

 private:
  static constexpr std::size_t kMostNamed = 8;
  struct Word {
    std::string word;
    std::size_t line;
  };
  std::vector<Word> words_;
  bool others_ = false;
};

}  // namespace welkin::obj
