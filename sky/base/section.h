// SPDX-License-Identifier: Apache-2.0
// A section of a file. Its keys are read by the ranges and defaults of its domain.
#pragma once

#include "sky/base/toml_table.h"

namespace welkin::base {

using det::Number3;

/// Getters throw Error(content) for a missing value or one out of its domain, and std::logic_error for a key without a
/// row.
class Section {
 public:
  /// The section `name` of the file's top-level table. `rows` must outlive the object.
  Section(TomlTable& file, std::string_view name, const Domain& rows)
      : rows_(&rows), name_(name), table_(file.table(name_)) {}

  TomlTable& table() { return table_; }

  double number(const std::string& key) { return table_.number(key, rangeOf(key), numberWithout(key)); }
  /// A number whose default depends on other keys.
  double number(const std::string& key, std::optional<double> otherwise) {
    return table_.number(key, rangeOf(key), otherwise);
  }
  int wholeNumber(const std::string& key);
  /// A whole number. Nothing when the key is absent or holds a word of the row's list.
  std::optional<int> wholeNumberIfAny(const std::string& key);
  /// A word of the row's list. The row's default when the key is absent.
  std::string word(const std::string& key);
  Number3 colour(const std::string& key) { return table_.colour(key, rangeOf(key), Number3(*numberWithout(key))); }
  Curve curve(const std::string& key) { return table_.curve(key, rangeOf(key), *numberWithout(key)); }
  Curve colourCurve(const std::string& key) {
    return table_.colourCurve(key, rangeOf(key), Number3(*numberWithout(key)));
  }
  /// Rows of a key time and the parts. Empty when the key is absent.
  std::vector<std::vector<double>> rows(const std::string& key, std::initializer_list<std::string_view> parts);
  /// A list of hours. Evenly spread, `otherwise` of them, when the key is absent or holds the row's word.
  std::vector<double> hours(const std::string& key, int otherwise);
  /// Whether the key is there and is not "auto".
  bool isFixed(const std::string& key);

  /// Throws for keys that are not allowed beside a path.
  void excludeBesidePath(const std::string& must);

  const Range& rangeOf(std::string_view key, std::string_view part = "") const { return parameter(key, part).range; }
  /// The row's default, if it is a number.
  std::optional<double> numberWithout(std::string_view key) const;

 private:
  const Parameter& parameter(std::string_view key, std::string_view part = "") const {
    return parameterOf(*rows_, name_, key, part);
  }

  const Domain* rows_;
  std::string name_;
  TomlTable table_;
};

}  // namespace welkin::base
