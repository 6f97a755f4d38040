// SPDX-License-Identifier: Apache-2.0
#include "sky/toml_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "sky/error.h"

namespace welkin::sky {
namespace {

std::string written(const toml::node& node) {
  std::ostringstream text;
  text << toml::node_view<const toml::node>(node);
  std::string s = text.str();
  return s.size() > 60 ? s.substr(0, 57) + "..." : s;
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

std::string phrase(Range range) {
  if (range.low == -HUGE_VAL) return fmt::format("at most {}", range.high);
  return fmt::format("{} to {}", range.low, range.high);
}

}  // namespace

std::vector<double> evenHours(int count) {
  std::vector<double> hours;
  for (int i = 0; i < count; ++i) hours.push_back(24.0 * i / count);
  return hours;
}

TomlTable::TomlTable(std::string file, const toml::table* table, std::string path)
    : file_(std::move(file)), table_(table), path_(std::move(path)) {}

void TomlTable::refuse(const std::string& key, const toml::node* at, const std::string& must) const {
  if (at == nullptr) throw Error(ExitStatus::content, fmt::format("{}: {}{}: {}", file_, path_, key, must));
  throw Error(ExitStatus::content,
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
  if (!value || !n.is_number()) refuse(key, &n, fmt::format("must be a number, {}", phrase(range)));
  if (!(*value >= range.low && *value <= range.high)) refuse(key, &n, fmt::format("must be {}", phrase(range)));
  return *value;
}

double TomlTable::number(const std::string& key, Range range, std::optional<double> otherwise) {
  const toml::node* n = node(key);
  if (n != nullptr) return numberOf(key, *n, range);
  if (!otherwise) refuse(key, nullptr, fmt::format("is missing; it must be {}", phrase(range)));
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
    refuse(key, &n, fmt::format("must be a colour, [r, g, b], each {}", phrase(range)));
  return {numberOf(key, *a->get(0), range), numberOf(key, *a->get(1), range), numberOf(key, *a->get(2), range)};
}

Number3 TomlTable::colour(const std::string& key, Range range, const Number3& otherwise) {
  const toml::node* n = node(key);
  return n != nullptr ? colourOf(key, *n, range) : otherwise;
}

Curve TomlTable::keyed(const std::string& key, const toml::array& keys, int components, Range range) const {
  Curve curve{components, {}, {}};
  if (keys.empty()) refuse(key, &keys, "must have at least one key");
  for (const toml::node& entry : keys) {
    const toml::array* pair = entry.as_array();
    if (pair == nullptr || pair->size() != 2)
      refuse(key, &entry,
             components == 1 ? "every key must be [time_h, value]" : "every key must be [time_h, [r, g, b]]");
    const double time = numberOf(key, *pair->get(0), {-HUGE_VAL, HUGE_VAL});
    if (!(time >= 0.0 && time < 24.0)) refuse(key, &entry, "key times must be in [0, 24)");
    if (!curve.time_h.empty() && !(time > curve.time_h.back())) refuse(key, &entry, "key times must ascend");
    curve.time_h.push_back(time);
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
    std::vector<double> numbers = {numberOf(key, *row->get(0), {-HUGE_VAL, HUGE_VAL})};
    if (!(numbers[0] >= 0.0 && numbers[0] < 24.0)) refuse(key, &entry, "key times must be in [0, 24)");
    if (!rows.empty() && !(numbers[0] > rows.back()[0])) refuse(key, &entry, "key times must ascend");
    for (std::size_t i = 0; i < ranges.size(); ++i) numbers.push_back(numberOf(key, *row->get(i + 1), ranges[i]));
    rows.push_back(std::move(numbers));
  }
  return rows;
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

void TomlTable::finish() const {
  if (table_ == nullptr) return;
  for (const auto& [key, value] : *table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
      return editDistance(name, a) < editDistance(name, b);
    });
    refuse(name, &value,
           nearest != known_.end() ? fmt::format("unknown key; the nearest known one is \"{}\"", *nearest)
                                   : "unknown key");
  }
}

}  // namespace welkin::sky
