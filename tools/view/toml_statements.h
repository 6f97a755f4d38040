// SPDX-License-Identifier: Apache-2.0
// Where the statements of a TOML text stand, so that one can be changed and all others keep their bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace welkin::view {

struct TomlStatement {
  enum class Kind { table, list_table, value } kind = Kind::value;
  std::string table;       ///< the header above, or that of the statement; parts joined by "."; empty at the top
  std::string key;         ///< of a value, likewise
  std::size_t begin = 0;   ///< of its line
  std::size_t value = 0;   ///< first byte of a value, or of a header
  std::size_t end = 0;     ///< behind the value or the header
  std::size_t behind = 0;  ///< begin of the next line
};

/// In their order. `text` must be TOML; anything else gives some list, within the text.
std::vector<TomlStatement> statementsOf(std::string_view text);

struct TomlList {
  struct Entry {
    std::size_t begin = 0, end = 0;
    std::size_t comma = std::string_view::npos;  ///< behind it, if there is one
  };
  std::size_t open = 0, close = 0;  ///< its brackets
  std::vector<Entry> entry;
};

/// The list whose bracket is at `open`.
TomlList listAt(std::string_view text, std::size_t open);

}  // namespace welkin::view
