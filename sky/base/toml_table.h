// SPDX-License-Identifier: Apache-2.0
// Reads a TOML table key by key; every message names file, line, key and value and what is allowed.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sky/base/curve.h"
#include "sky/base/domain.h"
#include "sky/base/error.h"

namespace welkin::base {

using det::Number3;

/// Parses a file's text. Throws Error(content) when it is not TOML, nests more than 16 lists or
/// tables, or has a key of more than 16 parts.
toml::table parseToml(const std::string& file, std::string_view text);

/// A table of a file, or an absent table without keys. Getters throw Error(content). A key that no getter asked for is
/// unknown; finish reports it with the nearest name.
class TomlTable {
 public:
  /// `path` is the prefix of keys in messages, such as "sun."; it is empty for the top-level table.
  TomlTable(std::string file, const toml::table* table, std::string path);

  TomlTable table(const std::string& key);
  bool has(const std::string& key);
  /// Null when the key is absent.
  const toml::node* node(const std::string& key);

  double number(const std::string& key, Range range, std::optional<double> otherwise);
  int integer(const std::string& key, int low, int high, std::optional<int> otherwise);
  std::string string(const std::string& key, const std::vector<std::string>& allowed, const std::string& otherwise);
  Number3 colour(const std::string& key, Range range, const Number3& otherwise);
  /// A number, or [[time_h, number], ...].
  Curve curve(const std::string& key, Range range, double otherwise);
  /// A colour, or [[time_h, colour], ...].
  Curve colourCurve(const std::string& key, Range range, const Number3& otherwise);
  /// Rows of `width` numbers: [[a, b, ...], ...]. The first number is a key time; `ranges` bound the others.
  std::vector<std::vector<double>> rows(const std::string& key, const std::vector<Range>& ranges);
  /// Lists of `width` numbers: [[a, b, ...], ...]. Messages show the form as `form`. Empty when the key is absent.
  std::vector<std::vector<double>> lists(const std::string& key, std::size_t width, Range range,
                                         const std::string& form);
  /// One such list. The key must be there.
  std::vector<double> list(const std::string& key, std::size_t width, Range range, const std::string& form);
  /// A list of hours in [0, 24), strictly ascending, or a number N in 1..most for the hours 24 i / N. `otherwise` is
  /// the N of an absent key.
  std::vector<double> hours(const std::string& key, int most, int otherwise, const char* also_word);

  /// Throws if any of the keys is there.
  void exclude(const std::vector<std::string>& keys, const std::string& must);
  /// Throws for a key that was never asked for.
  void finish() const;
  [[noreturn]] void refuse(const std::string& key, const toml::node* at, const std::string& must,
                           ExitStatus status = ExitStatus::content) const;

 private:
  double numberOf(const std::string& key, const toml::node& node, Range range) const;
  std::vector<double> listOf(const std::string& key, const toml::node& node, std::size_t width, Range range,
                             const std::string& form) const;
  Number3 colourOf(const std::string& key, const toml::node& node, Range range) const;
  double keyTime(const std::string& key, const toml::array& entry, double before) const;
  Curve keyed(const std::string& key, const toml::array& keys, int components, Range range) const;

  std::string file_;
  const toml::table* table_;
  std::string path_;
  std::vector<std::string> known_;
};

/// Returns the hours 24 i / count.
std::vector<double> evenHours(int count);

}  // namespace welkin::base
