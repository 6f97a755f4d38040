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

/// Parses a file's text. Throws Error(content) for what is not TOML, and for a key of more than 16 parts.
toml::table parseToml(const std::string& file, std::string_view text);

/// A table of a file, or an absent one, which has no keys. Getters throw Error(content); a key that no getter asked for
/// is unknown, which finish reports with the nearest name.
class TomlTable {
 public:
  /// `path` is how the table is written before a key, "sun.", or empty for the file's own table.
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
  /// Rows of `width` numbers: [[a, b, ...], ...], the first a key time; ranges for the others.
  std::vector<std::vector<double>> rows(const std::string& key, const std::vector<Range>& ranges);
  /// Lists of `width` numbers, [[a, b, ...], ...], which `form` shows in messages; none when absent.
  std::vector<std::vector<double>> lists(const std::string& key, std::size_t width, Range range,
                                         const std::string& form);
  /// One such list; it must be there.
  std::vector<double> list(const std::string& key, std::size_t width, Range range, const std::string& form);
  /// A list of hours in [0, 24), strictly ascending; or a number N in 1..most: hours 24 i / N; `otherwise` when absent.
  std::vector<double> hours(const std::string& key, int most, int otherwise, const char* also_word);

  /// Throws for any of the keys that is there.
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

/// Hours 24 i / count.
std::vector<double> evenHours(int count);

}  // namespace welkin::base
