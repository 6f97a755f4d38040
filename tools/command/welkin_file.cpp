// SPDX-License-Identifier: Apache-2.0
#include "command/welkin_file.h"

#include <filesystem>

#include "command/arguments.h"
#include "sky/base/atomic_file.h"

namespace welkin::command {

format::Kind kindOfFile(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") return format::Kind::sky;
  const auto bytes = base::readFile(path);
  return format::kindOf(bytes).value_or(format::Kind::sky);
}

Sky openSky(const std::string& path) {
  Sky sky;
  const Status status = sky.open(path);
  require(status.code, "", status.message.c_str());  // the message names the path
  return sky;
}

}  // namespace welkin::command
