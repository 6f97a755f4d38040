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

  /// Maps the file at `path`, UTF-8 on Windows. Returns 0, or the system's error. An empty file maps to no bytes.
  int open(const char* path);
  std::span<const std::byte> bytes() const { return bytes_; }

  /// Writes the reason for such an error, in the system's words.
  static void describe(int error, char* text, std::size_t size);

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace welkin::core
