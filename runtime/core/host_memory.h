// SPDX-License-Identifier: Apache-2.0
// The game's memory, or malloc's, for all that opening a sky allocates.
#pragma once

#include <welkin/types.h>

#include <cstddef>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace welkin::core {

/// Allocates by the game's functions, or by malloc if there are none.
class HostMemory {
 public:
  HostMemory() = default;
  explicit HostMemory(const WelkinAllocator& host) : host_(host) {}

  /// Memory for `bytes` > 0 bytes at a multiple of `alignment`, at most that of max_align_t. Null when there is none.
  void* allocate(std::size_t bytes, std::size_t alignment) const {
    return host_.allocate != nullptr ? host_.allocate(host_.user, bytes, alignment) : std::malloc(bytes);
  }
  void free(void* address, std::size_t bytes) const {
    if (host_.allocate == nullptr)
      std::free(address);
    else if (address != nullptr)
      host_.free(host_.user, address, bytes);
  }

 private:
  WelkinAllocator host_{};
};

/// Owns an array of numbers. Null until `allocate` succeeds.
template <typename T>
class HostArray {
  static_assert(std::is_trivial_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  HostArray() = default;
  HostArray(HostArray&& other) noexcept
      : memory_(other.memory_), address_(std::exchange(other.address_, nullptr)), count_(other.count_) {}
  HostArray& operator=(HostArray&& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(address_, other.address_);
    std::swap(count_, other.count_);
    return *this;
  }
  ~HostArray() { memory_.free(address_, count_ * sizeof(T)); }

  /// False when there is no memory. The numbers are not initialised.
  bool allocate(const HostMemory& memory, std::size_t count) {
    constexpr std::size_t kAlignment = alignof(std::max_align_t);
    HostArray array;
    array.memory_ = memory;
    array.count_ = count;
    array.address_ = static_cast<T*>(memory.allocate(count * sizeof(T), kAlignment));
    *this = std::move(array);
    return address_ != nullptr;
  }
  T* get() const { return address_; }

 private:
  HostMemory memory_;
  T* address_ = nullptr;
  std::size_t count_ = 0;
};

}  // namespace welkin::core
