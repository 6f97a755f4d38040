// SPDX-License-Identifier: Apache-2.0
// A game's allocator that counts, and that runs out of memory when a test says so.
#pragma once

#include <welkin/types.h>

#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>

namespace welkin::tests {

/// Counts what it gives and takes.
struct Heap {
  std::map<void*, std::size_t> held;
  std::size_t allocations = 0;
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< allocations; then there is no memory

  WelkinAllocator allocator() {
    WelkinAllocator a{};
    a.user = this;
    a.allocate = [](void* user, std::size_t bytes, std::size_t alignment) -> void* {
      auto& heap = *static_cast<Heap*>(user);
      REQUIRE((bytes > 0 && alignment > 0 && alignment <= 16 && (alignment & (alignment - 1)) == 0));
      if (heap.allocations == heap.most) return nullptr;
      ++heap.allocations;
      void* address = std::malloc(bytes);
      heap.held[address] = bytes;
      return address;
    };
    a.free = [](void* user, void* address, std::size_t bytes) {
      auto& heap = *static_cast<Heap*>(user);
      REQUIRE(heap.held.at(address) == bytes);
      heap.held.erase(address);
      std::free(address);
    };
    return a;
  }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [address, size] : held) sum += size;
    return sum;
  }
};

}  // namespace welkin::tests
