// SPDX-License-Identifier: Apache-2.0
// Bytes of a file, appended as little-endian numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace welkin::base {

class LittleEndian {
 public:
  void append32(std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) append(word, 4);
  }
  void append64(std::uint64_t value) { append(value, 8); }
  void appendText(std::string_view text) {
    for (const char c : text) bytes.push_back(static_cast<std::byte>(c));
  }
  /// Appends zeros up to a multiple of `alignment`.
  void align(std::size_t alignment) { bytes.resize((bytes.size() + alignment - 1) / alignment * alignment); }

  std::vector<std::byte> bytes;

 private:
  void append(std::uint64_t value, unsigned count) {
    for (unsigned i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xff));
  }
};

}  // namespace welkin::base
