// SPDX-License-Identifier: Apache-2.0
#include "command/welkin_file.h"

#include <filesystem>

#include "command/arguments.h"
#include "format/container.h"
#include "sky/base/atomic_file.h"

namespace welkin::command {

Holds whatHolds(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") return Holds::sky;
  const auto bytes = base::readFile(path);
  const format::Opened opened = format::openContainer(bytes);
  if (opened.file == nullptr) return Holds::sky;
  return opened.file->sector() != nullptr ? Holds::sector : opened.file->level() != nullptr ? Holds::level : Holds::sky;
}

Sky openSky(const std::string& path) {
  Sky sky;
  const Status status = sky.open(path);
  require(status.code, path, status.message.c_str());
  return sky;
}

}  // namespace welkin::command
