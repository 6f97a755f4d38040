// SPDX-License-Identifier: Apache-2.0
// Helpers of the fuzz targets: a folder for the input's file, and the permitted outcomes of an input.
#pragma once

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "sky/base/error.h"
#include "tests/folder.h"

/// The entry points: libFuzzer calls the first once, and it and the replay call the second with every input.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace welkin::fuzz {

/// Ends the program unless `holds`. libFuzzer and the replay then report the input.
inline void require(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

template <typename Vector3>
bool isFinite(const Vector3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// A folder of this process alone, in memory (/dev/shm) where the system has it.
class Folder {
 public:
  Folder() : folder_(parent()) {}

  std::filesystem::path write(const std::string& name, std::span<const std::uint8_t> bytes) const {
    return folder_.write(name, std::string(bytes.begin(), bytes.end()));
  }

 private:
  static std::filesystem::path parent() {
    const std::filesystem::path memory = "/dev/shm";
    std::error_code none;
    return std::filesystem::is_directory(memory, none) && ::access(memory.c_str(), W_OK) == 0
               ? memory
               : std::filesystem::temp_directory_path();
  }

  tests::Folder folder_;
};

/// Whether `read` accepts the input. It may refuse it only by an Error about a file or its content, with a message. Any
/// other exception ends the program.
template <typename Read>
bool accepts(Read&& read) {
  try {
    read();
    return true;
  } catch (const base::Error& e) {
    require(e.what()[0] != '\0', "an error has a message");
    require(e.status() == base::ExitStatus::content || e.status() == base::ExitStatus::file, "an error is the input's");
    return false;
  }
}

}  // namespace welkin::fuzz
