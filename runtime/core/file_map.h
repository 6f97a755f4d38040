// SPDX-License-Identifier: Apache-2.0
// A read-only memory map of a whole file.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

namespace welkin::core {

/// Unmaps on destruction. Empty until open succeeds.
class FileMap {
 public:
  FileMap() = default;
  FileMap(FileMap&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}
  FileMap& operator=(FileMap&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~FileMap();

  /// Maps the file at `path`. Returns 0, or the errno if the file cannot be mapped. An empty file maps to no bytes.
  int open(const char* path);
  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace welkin::core
