// SPDX-License-Identifier: Apache-2.0
#include "baked/welkin_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "sky/bake/runtime_error.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::baked {

format::Kind kindOfFile(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") return format::Kind::sky;
  const auto bytes = base::readFile(path);
  return format::kindOf(bytes).value_or(format::Kind::sky);
}

std::string skyFileOf(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return path;
  const auto file = std::filesystem::path(path) / "sky.welkin";
  if (!std::filesystem::exists(file, error))
    throw base::Error(base::ExitStatus::file,
                      fmt::format("{}: holds no sky.welkin; welkin bake SKY.toml -o {} makes it", path, path));
  return file.string();
}

Sky openSky(const std::string& path) {
  Sky sky;
  const Status status = sky.open(path);
  bake::require(status.code, "", status.message.c_str());  // the message names the path
  return sky;
}

}  // namespace welkin::baked
