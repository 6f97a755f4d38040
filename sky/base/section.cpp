// SPDX-License-Identifier: Apache-2.0
#include "sky/base/section.h"

namespace welkin::base {

std::optional<double> Section::numberWithout(std::string_view key) const {
  const auto* number = std::get_if<double>(&parameter(key).otherwise);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

int Section::wholeNumber(const std::string& key) {
  const Range& range = rangeOf(key);
  const auto otherwise = numberWithout(key);
  return table_.integer(key, static_cast<int>(range.low), static_cast<int>(range.high),
                        otherwise ? std::optional(static_cast<int>(*otherwise)) : std::nullopt);
}

bool Section::isFixed(const std::string& key) {
  const toml::node* node = table_.node(key);
  if (node == nullptr) return false;
  return node->value<std::string>() != "auto";
}

std::optional<int> Section::wholeNumberIfAny(const std::string& key) {
  return isFixed(key) ? std::optional(wholeNumber(key)) : std::nullopt;
}

std::string Section::word(const std::string& key) {
  const Parameter& row = parameter(key);
  return table_.string(key, {row.words.begin(), row.words.end()},
                       std::string(std::get<std::string_view>(row.otherwise)));
}

std::vector<std::vector<double>> Section::rows(const std::string& key, std::initializer_list<std::string_view> parts) {
  std::vector<Range> ranges;
  for (const std::string_view part : parts) ranges.push_back(rangeOf(key, part));
  return table_.rows(key, ranges);
}

std::vector<double> Section::hours(const std::string& key, int otherwise) {
  const Parameter& row = parameter(key);
  const std::string word = row.words.empty() ? "" : std::string(row.words.front());
  return table_.hours(key, static_cast<int>(row.range.high), otherwise, word.empty() ? nullptr : word.c_str());
}

void Section::excludeBesidePath(const std::string& must) {
  std::vector<std::string> keys;
  for (const Parameter& row : *rows_)
    if (row.section == name_ && row.without_path) keys.emplace_back(row.key);
  table_.exclude(keys, must);
}

}  // namespace welkin::base
