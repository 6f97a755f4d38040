// SPDX-License-Identifier: Apache-2.0
#include "view/toml_statements.h"

#include <algorithm>

namespace welkin::view {
namespace {

bool isTomlBlank(char c) {
  return c == ' ' || c == '\t';
}

std::size_t behindLine(std::string_view text, std::size_t at) {
  const std::size_t line = text.find('\n', at);
  return line == std::string_view::npos ? text.size() : line + 1;
}

std::size_t behindBlanks(std::string_view text, std::size_t at) {
  while (at < text.size() && isTomlBlank(text[at])) ++at;
  return at;
}

/// Behind blanks, line breaks and comments.
std::size_t behindSpace(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (isTomlBlank(text[at]) || text[at] == '\n' || text[at] == '\r')
      ++at;
    else if (text[at] == '#')
      at = behindLine(text, at);
    else
      break;
  }
  return at;
}

std::size_t behindString(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool escapes = quote == '"';
  const std::string_view three = escapes ? "\"\"\"" : "'''";
  const bool is_long = text.substr(at, 3) == three;
  at += is_long ? 3 : 1;
  while (at < text.size()) {
    if (escapes && text[at] == '\\') {
      at = std::min(at + 2, text.size());
    } else if (is_long ? text.substr(at, 3) == three : text[at] == quote) {
      at += is_long ? 3 : 1;
      while (is_long && at < text.size() && text[at] == quote) ++at;  // up to two more belong to the string
      return at;
    } else {
      ++at;
    }
  }
  return at;
}

std::size_t behindValue(std::string_view text, std::size_t at) {
  if (at >= text.size()) return at;
  if (text[at] == '"' || text[at] == '\'') return behindString(text, at);
  if (text[at] == '[' || text[at] == '{') {
    int depth = 0;
    while (at < text.size()) {
      const char c = text[at];
      if (c == '"' || c == '\'') {
        at = behindString(text, at);
        continue;
      }
      if (c == '#') {
        at = behindLine(text, at);
        continue;
      }
      depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
      ++at;
      if (depth == 0) return at;
    }
    return at;
  }
  std::size_t end = at;
  while (end < text.size() && std::string_view(",]}#\n\r").find(text[end]) == std::string_view::npos) ++end;
  while (end > at && isTomlBlank(text[end - 1])) --end;
  return end;
}

/// Reads a key up to `stop` and leaves `at` there. Its parts are joined by ".".
std::string keyOf(std::string_view text, std::size_t& at, char stop) {
  std::string key;
  while (at < text.size() && text[at] != stop && text[at] != '\n') {
    if (text[at] == '"' || text[at] == '\'') {
      const std::size_t end = behindString(text, at);
      key += text.substr(at + 1, end > at + 1 ? end - at - 2 : 0);
      at = end;
    } else {
      if (!isTomlBlank(text[at]) && text[at] != '\r') key += text[at];
      ++at;
    }
  }
  return key;
}

}  // namespace

std::vector<TomlStatement> statementsOf(std::string_view text) {
  std::vector<TomlStatement> list;
  std::string table;
  for (std::size_t line = 0; line < text.size();) {
    std::size_t at = behindBlanks(text, line);
    if (at >= text.size() || text[at] == '\n' || text[at] == '\r' || text[at] == '#') {
      line = behindLine(text, at);
      continue;
    }
    TomlStatement s;
    s.begin = line;
    s.value = at;
    if (text[at] == '[') {
      const bool is_list = text.substr(at, 2) == "[[";
      s.kind = is_list ? TomlStatement::Kind::list_table : TomlStatement::Kind::table;
      at += is_list ? 2 : 1;
      table = keyOf(text, at, ']');
      s.end = std::min(at + (is_list ? 2 : 1), text.size());
    } else {
      s.key = keyOf(text, at, '=');
      s.value = behindBlanks(text, std::min(at + 1, text.size()));
      s.end = behindValue(text, s.value);
    }
    s.table = table;
    s.behind = behindLine(text, s.end);
    line = s.behind;
    list.push_back(std::move(s));
  }
  return list;
}

TomlList listAt(std::string_view text, std::size_t open) {
  TomlList list;
  list.open = open;
  std::size_t at = behindSpace(text, open + 1);
  while (at < text.size() && text[at] != ']') {
    TomlList::Entry entry;
    entry.begin = at;
    entry.end = behindValue(text, at);
    at = behindSpace(text, std::max(entry.end, at + 1));
    if (at < text.size() && text[at] == ',') {
      entry.comma = at;
      at = behindSpace(text, at + 1);
    }
    list.entry.push_back(entry);
  }
  list.close = std::min(at, text.size());
  return list;
}

}  // namespace welkin::view
