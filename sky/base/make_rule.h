// SPDX-License-Identifier: Apache-2.0
// Paths in rules of make.
#pragma once

#include <filesystem>
#include <string>

namespace welkin::base {

/// A path as a target or prerequisite of a make rule: blanks, # and $ are escaped.
inline std::string inMakeRule(const std::filesystem::path& path) {
  std::string out;
  for (const char c : path.string()) {
    if (c == ' ' || c == '#') out += '\\';
    if (c == '$') out += '$';
    out += c;
  }
  return out;
}

}  // namespace welkin::base
