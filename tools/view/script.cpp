// SPDX-License-Identifier: Apache-2.0
#include "view/script.h"

#include <fmt/format.h>

#include <sstream>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::view {

void runScript(Session& session, const std::string& path) {
  constexpr std::size_t kLargest = std::size_t{64} << 20;
  const std::vector<std::byte> bytes = base::readFile(path, kLargest);
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    try {
      session.perform(line);
    } catch (const base::Error& error) {
      throw base::Error(error.status(), fmt::format("{}:{}: {}", path, number, error.what()));
    }
  }
}

}  // namespace welkin::view
