// SPDX-License-Identifier: Apache-2.0
#include "sky/base/toml_file.h"

#include "sky/base/atomic_file.h"
#include "sky/base/toml_table.h"

namespace welkin::base {

TomlFile readToml(const std::filesystem::path& path) {
  TomlFile file{path, readFile(path, kLargestTomlFile), {}};
  file.root = parseToml(path.string(), {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
  return file;
}

}  // namespace welkin::base
