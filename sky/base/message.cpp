// SPDX-License-Identifier: Apache-2.0
#include "sky/base/message.h"

#include <fmt/format.h>

#include <algorithm>

namespace welkin::base {
namespace {

/// A character of UTF-8, or one byte that begins none.
struct Character {
  std::size_t bytes = 1;
  char32_t code = 0;
  bool valid = false;
};

/// Reads the character at the start of the text, which is not empty (The Unicode Standard, table 3-7).
Character firstOf(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {1, lead, true};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  char32_t code = lead & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3fU);
  }
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < kLeast[bytes] || surrogate || code > 0x10ffff) return {};
  return {bytes, code, true};
}

/// Whether a terminal may obey the character: controls, line and paragraph separators, directions of writing.
bool steers(char32_t code) {
  return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x61c || code == 0x200e || code == 0x200f ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;
}

std::string escaped(char32_t code) {
  if (code == U'\n') return "\\n";
  if (code == U'\r') return "\\r";
  if (code == U'\t') return "\\t";
  const auto number = static_cast<unsigned>(code);
  return number < 0x80 ? fmt::format("\\x{:02x}", number) : fmt::format("\\u{:04x}", number);
}

}  // namespace

std::string oneLine(std::string_view text) {
  text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const Character c = firstOf(text.substr(at));
    if (!c.valid)
      line += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[at]));
    else if (steers(c.code))
      line += escaped(c.code);
    else
      line += text.substr(at, c.bytes);
    at += c.bytes;
  }
  return line;
}

std::string shortened(std::string_view text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return std::string(text);
  std::size_t end = most_bytes - std::min<std::size_t>(most_bytes, 3);
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace welkin::base
