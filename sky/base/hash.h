// SPDX-License-Identifier: Apache-2.0
// XXH3-128 of bytes that come in pieces.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

struct XXH3_state_s;

namespace welkin::base {

struct Hash128 {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  bool operator==(const Hash128&) const = default;
};

/// 32 hexadecimal digits, the high half first.
std::string textOf(const Hash128& hash);

Hash128 hashOf(std::span<const std::byte> bytes);

class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  void addBytes(std::span<const std::byte> bytes);
  /// A number, or an object without padding.
  template <typename T>
  requires std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>
  void add(const T& value) { addBytes(std::as_bytes(std::span(&value, 1))); }
  /// Hashes the count, then each item. Items have no padding.
  template <typename T>
  void addAll(std::span<const T> values) {
    add(std::uint64_t{values.size()});
    addBytes(std::as_bytes(values));
  }
  void add(std::string_view text) { addAll(std::span(text.data(), text.size())); }

  Hash128 digest() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace welkin::base
