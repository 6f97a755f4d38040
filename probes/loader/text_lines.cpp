// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "sky/base/error.h"

namespace welkin::loader {
namespace {

constexpr std::string_view kSpace = " \t\r\f\v";

/// Start of a comment: a # at the start or after space, because names may contain a #.
std::size_t commentIn(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (at == 0 || kSpace.find(line[at - 1]) != std::string_view::npos) return at;
  return line.size();
}

}  // namespace

bool TextLines::next() {
  while (!rest_.empty()) {
    line_.clear();
    line_number_ += lines_joined_;
    lines_joined_ = 0;
    for (bool joined = true; joined && !rest_.empty();) {
      const std::size_t end = rest_.find('\n');
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      ++lines_joined_;
      while (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      joined = line.ends_with('\\');
      line_ += joined ? line.substr(0, line.size() - 1) : line;
      if (joined) line_ += ' ';
    }
    line_.resize(commentIn(line_));
    words_.clear();
    const std::string_view line = line_;
    for (std::size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
      words_.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(kSpace, end);
    }
    if (!words_.empty()) return true;
  }
  return false;
}

std::string_view TextLines::rest() const {
  if (words_.size() < 2) return {};
  return {words_[1].data(), static_cast<std::size_t>(words_.back().data() + words_.back().size() - words_[1].data())};
}

double TextLines::number(std::size_t i) const {
  if (i >= words_.size()) refuse(fmt::format("{} needs at least {} numbers", words_[0], i));
  std::string_view word = words_[i];
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool out_of_range = error == std::errc::result_out_of_range;
  if (out_of_range && word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos)
    value = std::numeric_limits<double>::infinity();
  if ((error != std::errc() && !out_of_range) || end != word.data() + word.size())
    refuse(fmt::format("\"{}\" is not a number", words_[i].substr(0, 40)));
  return value;
}

void TextLines::refuse(const std::string& why) const {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: line {}: {}", file_, line_number_ + 1, why));
}

bool parseWhole(std::string_view word, int& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace welkin::loader
