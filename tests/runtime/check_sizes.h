// SPDX-License-Identifier: Apache-2.0
// A check of structs that can grow: a function keeps to the size that the caller states.
#pragma once

#include <welkin/types.h>

#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace welkin::tests {

/// Calls `describe` with a struct of every size up to the library's, and checks that it keeps to that size. `first` is
/// the size of the struct's first release.
template <typename Struct, typename Describe>
void checkSizes(std::size_t first, const Describe& describe) {
  struct Guarded {
    Struct value;
    unsigned char after[64];
  };
  for (std::uint32_t size = 0; size <= sizeof(Struct) + 8; size += 4) {
    CAPTURE(size);
    Guarded guarded{};
    std::memset(static_cast<void*>(&guarded), 0xa5, sizeof guarded);
    guarded.value.struct_size = size;
    const WelkinResult result = describe(&guarded.value);
    CHECK(result == (size >= first && size <= sizeof(Struct) ? WELKIN_OK : WELKIN_ERROR_ARGUMENT));
    CHECK(guarded.value.struct_size == size);
    const auto* bytes = reinterpret_cast<const unsigned char*>(&guarded);
    for (std::size_t i = result == WELKIN_OK ? size : 4; i < sizeof guarded; ++i) REQUIRE(bytes[i] == 0xa5);
  }
}

}  // namespace welkin::tests
