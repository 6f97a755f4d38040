// SPDX-License-Identifier: Apache-2.0
// What the runtime's unit tests need on a system that bakes nothing: a main, and the small sky from the file that
// WELKIN_SMALL_FILE in the environment names.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>

#include "tests/folder.h"
#include "tests/runtime/small_file.h"

namespace welkin::tests {

const std::vector<std::byte>& smallFile() {
  static const std::vector<std::byte> kBytes = [] {
    const char* path = std::getenv("WELKIN_SMALL_FILE");
    const std::string text = path == nullptr ? std::string() : readBytes(path);
    if (text.empty()) throw std::runtime_error("WELKIN_SMALL_FILE names no file");
    std::vector<std::byte> bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    return bytes;
  }();
  return kBytes;
}

}  // namespace welkin::tests
