// SPDX-License-Identifier: Apache-2.0
#include "sky/base/toml_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "sky/base/message.h"

namespace welkin::base {
namespace {

constexpr std::size_t kMostShown = 60;  // bytes of a value in a message

std::string written(const toml::node& node) {
  std::ostringstream text;
  text << toml::node_view<const toml::node>(node);
  return shortened(text.str(), kMostShown);
}

/// Returns the end of the string whose first quote is at `i`: its last quote, or the place where it is cut off.
std::size_t endOfString(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const bool lines = text.substr(i, 3) == std::string(3, quote);
  for (i += lines ? 3 : 1; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"')
      ++i;
    else if (!lines && (text[i] == quote || text[i] == '\n'))
      return i;
    else if (lines && text.substr(i, 3) == std::string(3, quote))
      return i + 2;
  }
  return text.size();
}

/// A place in a text, and what is wrong there.
struct TooDeep {
  std::size_t place;
  const char* why;
};

/// Finds a key of more than 16 parts, and more than 16 lists and tables within each other. toml++ recurses over both;
/// its own limit, 256 values, takes more than a small stack.
std::optional<TooDeep> findTooDeep(std::string_view text) {
  constexpr int kMostParts = 16, kDeepest = 16;
  int parts = 1;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' || c == '\'')
      i = endOfString(text, i);
    else if (c == '#')
      i = std::min(text.find('\n', i), text.size()) - 1;
    else if (c == '.' && ++parts > kMostParts)
      return TooDeep{i, "a key has more than 16 parts"};
    else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos)
      parts = 1;
    if ((c == '[' || c == '{') && ++depth > kDeepest)
      return TooDeep{i, "more than 16 lists or tables within each other"};
    if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  return std::nullopt;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j)
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])}));
  }
  return row.back();
}

std::string rangeText(Range range) {
  return fmt::format("{} to {}", range.low, range.high);
}

}  // namespace

std::vector<double> evenHours(int count) {
  std::vector<double> hours;
  for (int i = 0; i < count; ++i) hours.push_back(24.0 * i / count);
  return hours;
}

toml::table parseToml(const std::string& file, std::string_view text) {
  if (const auto found = findTooDeep(text)) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(found->place), '\n');
    throw Error(ExitStatus::content, fmt::format("{}:{}: {}", file, line, found->why));
  }
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw Error(ExitStatus::content, fmt::format("{}:{}: not TOML: {}", file, e.source().begin.line, e.description()));
  }
}

TomlTable::TomlTable(std::string file, const toml::table* table, std::string path)
    : file_(std::move(file)), table_(table), path_(std::move(path)) {}

void TomlTable::refuse(const std::string& key, const toml::node* at, const std::string& must, ExitStatus status) const {
  if (at == nullptr) throw Error(status, fmt::format("{}: {}{}: {}", file_, path_, key, must));
  throw Error(status,
              fmt::format("{}:{}: {}{} = {}: {}", file_, at->source().begin.line, path_, key, written(*at), must));
}

const toml::node* TomlTable::node(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return table_ != nullptr ? table_->get(key) : nullptr;
}

bool TomlTable::has(const std::string& key) {
  return node(key) != nullptr;
}

TomlTable TomlTable::table(const std::string& key) {
  const toml::node* n = node(key);
  if (n != nullptr && !n->is_table()) refuse(key, n, fmt::format("must be a table, [{}]", key));
  return TomlTable(file_, n != nullptr ? n->as_table() : nullptr, path_ + key + ".");
}

double TomlTable::numberOf(const std::string& key, const toml::node& n, Range range) const {
  const auto value = n.value<double>();
  if (!value || !n.is_number()) refuse(key, &n, fmt::format("must be a number, {}", rangeText(range)));
  if (!range.contains(*value)) refuse(key, &n, fmt::format("must be {}", rangeText(range)));
  return *value;
}

double TomlTable::number(const std::string& key, Range range, std::optional<double> otherwise) {
  const toml::node* n = node(key);
  if (n != nullptr) return numberOf(key, *n, range);
  if (!otherwise) refuse(key, nullptr, fmt::format("is missing; it must be {}", rangeText(range)));
  return *otherwise;
}

int TomlTable::integer(const std::string& key, int low, int high, std::optional<int> otherwise) {
  const toml::node* n = node(key);
  const auto must = fmt::format("must be a whole number, {} to {}", low, high);
  if (n == nullptr && !otherwise) refuse(key, nullptr, "is missing; it " + must);
  if (n == nullptr) return *otherwise;
  const auto value = n->is_integer() ? n->value<std::int64_t>() : std::nullopt;
  if (!value || *value < low || *value > high) refuse(key, n, must);
  return static_cast<int>(*value);
}

std::string TomlTable::string(const std::string& key, const std::vector<std::string>& allowed,
                              const std::string& otherwise) {
  const toml::node* n = node(key);
  if (n == nullptr) return otherwise;
  const auto value = n->value<std::string>();
  if (!value || (!allowed.empty() && std::find(allowed.begin(), allowed.end(), *value) == allowed.end()))
    refuse(key, n,
           allowed.empty() ? "must be a string" : fmt::format("must be one of \"{}\"", fmt::join(allowed, "\", \"")));
  return *value;
}

Number3 TomlTable::colourOf(const std::string& key, const toml::node& n, Range range) const {
  const toml::array* a = n.as_array();
  if (a == nullptr || a->size() != 3)
    refuse(key, &n, fmt::format("must be a colour, [r, g, b], each {}", rangeText(range)));
  return {numberOf(key, *a->get(0), range), numberOf(key, *a->get(1), range), numberOf(key, *a->get(2), range)};
}

Number3 TomlTable::colour(const std::string& key, Range range, const Number3& otherwise) {
  const toml::node* n = node(key);
  return n != nullptr ? colourOf(key, *n, range) : otherwise;
}

/// Reads the time of a key, which must lie after `before`.
double TomlTable::keyTime(const std::string& key, const toml::array& entry, double before) const {
  const auto time = entry.get(0)->value<double>();
  if (!time || !entry.get(0)->is_number() || !(*time >= 0.0 && *time < 24.0))
    refuse(key, &entry, "key times must be numbers in [0, 24)");
  if (!(*time > before)) refuse(key, &entry, "key times must ascend");
  return *time;
}

Curve TomlTable::keyed(const std::string& key, const toml::array& keys, int components, Range range) const {
  Curve curve{components, {}, {}};
  if (keys.empty()) refuse(key, &keys, "must have at least one key");
  for (const toml::node& entry : keys) {
    const toml::array* pair = entry.as_array();
    if (pair == nullptr || pair->size() != 2)
      refuse(key, &entry,
             components == 1 ? "every key must be [time_h, value]" : "every key must be [time_h, [r, g, b]]");
    curve.time_h.push_back(keyTime(key, *pair, curve.time_h.empty() ? -1.0 : curve.time_h.back()));
    if (components == 1) {
      curve.value.push_back(numberOf(key, *pair->get(1), range));
    } else {
      const Number3 c = colourOf(key, *pair->get(1), range);
      curve.value.insert(curve.value.end(), {c.x, c.y, c.z});
    }
  }
  return curve;
}

Curve TomlTable::curve(const std::string& key, Range range, double otherwise) {
  const toml::node* n = node(key);
  if (n == nullptr) return Curve::constant(otherwise);
  return n->is_array() ? keyed(key, *n->as_array(), 1, range) : Curve::constant(numberOf(key, *n, range));
}

Curve TomlTable::colourCurve(const std::string& key, Range range, const Number3& otherwise) {
  const toml::node* n = node(key);
  if (n == nullptr) return Curve::constant(otherwise);
  const toml::array* a = n->as_array();
  const bool keys = a != nullptr && (a->empty() || a->get(0)->is_array());
  return keys ? keyed(key, *a, 3, range) : Curve::constant(colourOf(key, *n, range));
}

std::vector<std::vector<double>> TomlTable::rows(const std::string& key, const std::vector<Range>& ranges) {
  const toml::node* n = node(key);
  std::vector<std::vector<double>> rows;
  if (n == nullptr) return rows;
  const toml::array* a = n->as_array();
  if (a == nullptr || a->empty()) refuse(key, n, "must be a list of at least one key");
  for (const toml::node& entry : *a) {
    const toml::array* row = entry.as_array();
    if (row == nullptr || row->size() != ranges.size() + 1)
      refuse(key, &entry, fmt::format("every key must be {} numbers, the time in hours first", ranges.size() + 1));
    std::vector<double> numbers = {keyTime(key, *row, rows.empty() ? -1.0 : rows.back()[0])};
    for (std::size_t i = 0; i < ranges.size(); ++i) numbers.push_back(numberOf(key, *row->get(i + 1), ranges[i]));
    rows.push_back(std::move(numbers));
  }
  return rows;
}

std::vector<double> TomlTable::listOf(const std::string& key, const toml::node& n, std::size_t width, Range range,
                                      const std::string& form) const {
  const toml::array* a = n.as_array();
  if (a == nullptr || a->size() != width) refuse(key, &n, fmt::format("must be {}", form));
  std::vector<double> numbers;
  for (const toml::node& number : *a) numbers.push_back(numberOf(key, number, range));
  return numbers;
}

std::vector<double> TomlTable::list(const std::string& key, std::size_t width, Range range, const std::string& form) {
  const toml::node* n = node(key);
  if (n == nullptr) refuse(key, nullptr, fmt::format("is missing; it must be {}", form));
  return listOf(key, *n, width, range, form);
}

std::vector<std::vector<double>> TomlTable::lists(const std::string& key, std::size_t width, Range range,
                                                  const std::string& form) {
  std::vector<std::vector<double>> lists;
  const toml::node* n = node(key);
  if (n == nullptr) return lists;
  if (!n->is_array()) refuse(key, n, fmt::format("must be a list, [{}, ...]", form));
  for (const toml::node& entry : *n->as_array()) lists.push_back(listOf(key, entry, width, range, form));
  return lists;
}

std::vector<double> TomlTable::hours(const std::string& key, int most, int otherwise, const char* also_word) {
  const toml::node* n = node(key);
  const std::string word = also_word != nullptr ? fmt::format("\"{}\", ", also_word) : "";
  const auto must = fmt::format(
      "must be {}a number of hours spread evenly, 1 to {}, or a list of hours in [0, 24), ascending", word, most);
  if (n == nullptr || (also_word != nullptr && n->value<std::string>() == also_word)) return evenHours(otherwise);
  if (n->is_integer()) {
    const std::int64_t count = *n->value<std::int64_t>();
    if (count < 1 || count > most) refuse(key, n, must);
    return evenHours(static_cast<int>(count));
  }
  const toml::array* a = n->as_array();
  if (a == nullptr || a->empty() || a->size() > static_cast<std::size_t>(most)) refuse(key, n, must);
  std::vector<double> hours;
  for (const toml::node& entry : *a) {
    const auto hour = entry.value<double>();
    if (!hour || !entry.is_number()) refuse(key, &entry, must);
    hours.push_back(*hour);
  }
  if (!format::areKeyTimes(hours)) refuse(key, n, must);
  return hours;
}

void TomlTable::exclude(const std::vector<std::string>& keys, const std::string& must) {
  for (const std::string& key : keys)
    if (const toml::node* n = node(key); n != nullptr) refuse(key, n, must);
}

void TomlTable::finish() const {
  if (table_ == nullptr) return;
  for (const auto& [key, value] : *table_) {
    if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
    const std::string name = shortened(key.str(), kMostShown);
    const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
      return editDistance(name, a) < editDistance(name, b);
    });
    refuse(name, &value,
           nearest != known_.end() ? fmt::format("unknown key; the nearest known one is \"{}\"", *nearest)
                                   : "unknown key");
  }
}

}  // namespace welkin::base
