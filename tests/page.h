// SPDX-License-Identifier: Apache-2.0
// A part of a page that a program writes: between <!-- NAME: command --> and <!-- /NAME -->.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/folder.h"

namespace welkin::tests {

/// The page with `text`, whole lines, in its part `name`. Throws std::runtime_error when it has none.
inline std::string withPart(const std::string& page, const std::string& name, const std::string& text) {
  const std::size_t opening = page.find("<!-- " + name + ":");
  const std::size_t first = opening == std::string::npos ? opening : page.find('\n', opening);
  const std::size_t last = first == std::string::npos ? first : page.find("<!-- /" + name + " -->", first);
  if (last == std::string::npos) throw std::runtime_error("no part <!-- " + name + ": --> in the page");
  return page.substr(0, first + 1) + text + page.substr(last);
}

/// Writes the part into the file, or says whether the file has it as it is. The exit status of a program that does
/// nothing else: 0, or 1 when the page is out of date.
inline int bringUpToDate(const std::filesystem::path& file, const std::string& name, const std::string& text,
                         bool write) {
  const std::string page = readBytes(file);
  const std::string wanted = withPart(page, name, text);
  if (page == wanted) return 0;
  if (!write) {
    std::fprintf(stderr, "%s: the part \"%s\" is out of date; its comment says what writes it\n", file.c_str(),
                 name.c_str());
    return 1;
  }
  std::ofstream(file, std::ios::binary) << wanted;
  return 0;
}

}  // namespace welkin::tests
