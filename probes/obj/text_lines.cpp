// SPDX-License-Identifier: Apache-2.0
#include "probes/obj/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::obj {
namespace {

constexpr std::string_view kSpace = " \t\r\f\v";
constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

/// Start of a comment: a # at the start or after space, because names may contain a #.
std::size_t commentIn(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (at == 0 || kSpace.find(line[at - 1]) != std::string_view::npos) return at;
  return line.size();
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
}

/// Name of the encoding that is not read; empty for text that is.
std::string_view encodingOf(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xff\xfe\0\0"sv) || text.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
  if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv)) return "UTF-16";
  if (text.find('\0') == std::string_view::npos) return {};
  const bool every_other = text.size() > 3 && (text[0] == '\0') != (text[1] == '\0') &&
                           (text[0] == '\0') == (text[2] == '\0') && (text[1] == '\0') == (text[3] == '\0');
  return every_other ? "UTF-16" : "a binary file";
}

}  // namespace

TextLines::TextLines(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {
  const std::string_view encoding = encodingOf(text);
  if (!encoding.empty())
    throw base::Error(base::ExitStatus::content, fmt::format("{}: is {}; ASCII and UTF-8 are read", file_, encoding));
}

bool TextLines::next() {
  while (!rest_.empty()) {
    line_.clear();
    line_number_ += lines_joined_;
    lines_joined_ = 0;
    for (bool joined = true; joined && !rest_.empty();) {
      const std::size_t end = rest_.find_first_of("\r\n");
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(line.size(), rest_.size()));
      rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
      ++lines_joined_;
      while (line.starts_with(kUtf8Mark)) line.remove_prefix(kUtf8Mark.size());
      joined = line.ends_with('\\') && !trimmed(line).starts_with('#');  // a comment may end with a Windows folder
      line_ += joined ? line.substr(0, line.size() - 1) : line;
      if (joined) line_ += ' ';
    }
    words_.clear();
    const std::string_view line = std::string_view(line_).substr(0, commentIn(line_));
    for (std::size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
      words_.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(kSpace, end);
    }
    if (!words_.empty()) return true;
  }
  return false;
}

std::string TextLines::keyword() const {
  return lowerCase(words_[0]);
}

std::string_view TextLines::nameFrom(std::size_t i) const {
  const char* first = i < words_.size() ? words_[i].data() : words_.back().data() + words_.back().size();
  std::string_view name = trimmed({first, static_cast<std::size_t>(line_.data() + line_.size() - first)});
  if (i >= words_.size() && name.starts_with('#')) return {};  // no name, then a comment
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = trimmed(name.substr(1, name.size() - 2));
  return name;
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
    refuse(fmt::format("\"{}\" is not a number", base::shortened(words_[i], 40)));
  return value;
}

void TextLines::refuse(const std::string& why) const {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: line {}: {}", file_, lineNumber(), why));
}

std::string lowerCase(std::string_view word) {
  std::string result(word);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string_view withoutComment(std::string_view name) {
  return trimmed(name.substr(0, commentIn(name)));
}

bool parseWhole(std::string_view word, int& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace welkin::obj
