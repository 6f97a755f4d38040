// SPDX-License-Identifier: Apache-2.0
#include "view/words.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "sky/base/error.h"

namespace welkin::view {
namespace {

[[noreturn]] void fail(const std::string& message) {
  throw base::Error(base::ExitStatus::content, message);
}

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Parses the whole of a text.
template <typename Number>
bool parse(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

std::vector<std::string> wordsOf(std::string_view line) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < line.size();) {
    if (isBlank(line[i])) {
      ++i;
    } else if (line[i] == '#') {
      break;
    } else if (line[i] == '"') {
      const std::size_t end = line.find('"', i + 1);
      if (end == std::string_view::npos) fail(fmt::format("{}: the quote has no end", line.substr(i)));
      words.emplace_back(line.substr(i + 1, end - i - 1));
      i = end + 1;
    } else {
      std::size_t end = i;
      while (end < line.size() && !isBlank(line[end])) ++end;
      words.emplace_back(line.substr(i, end - i));
      i = end;
    }
  }
  return words;
}

void Words::refuse(const char* what, const std::string& allowed) const {
  if (done()) fail(fmt::format("{}: {} is missing: {}", words_[0], what, allowed));
  fail(fmt::format("{}: {} is \"{}\", must be {}", words_[0], what, words_[next_], allowed));
}

double Words::number(const char* what, double low, double high) {
  double value = 0.0;
  if (done() || !parse(words_[next_], value) || !(value >= low && value <= high))
    refuse(what, fmt::format("a number in {:g} to {:g}", low, high));
  ++next_;
  return value;
}

std::size_t Words::count(const char* what, std::size_t low, std::size_t high) {
  std::size_t value = 0;
  if (done() || !parse(words_[next_], value) || value < low || value > high)
    refuse(what, fmt::format("a whole number in {} to {}", low, high));
  ++next_;
  return value;
}

std::size_t Words::choice(const char* what, std::initializer_list<const char*> allowed) {
  std::string names;
  std::size_t index = 0;
  for (const char* name : allowed) {
    if (!done() && words_[next_] == name) {
      ++next_;
      return index;
    }
    names += (index++ == 0 ? "" : ", ") + std::string(name);
  }
  refuse(what, "one of " + names);
}

const std::string& Words::text(const char* what) {
  if (done() || words_[next_].empty()) refuse(what, "a text");
  return words_[next_++];
}

bool Words::take(std::string_view word) {
  if (done() || words_[next_] != word) return false;
  ++next_;
  return true;
}

void Words::end() const {
  if (!done()) fail(fmt::format("{}: \"{}\" is one word too many", words_[0], words_[next_]));
}

}  // namespace welkin::view
