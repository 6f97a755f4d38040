// SPDX-License-Identifier: Apache-2.0
// Where OpenEXR writes a file's bytes: into memory.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace welkin::image {

/// Collects the output of OpenEXR, which goes back to fill in the offsets of the lines.
class ExrBytes : public Imf::OStream {
 public:
  ExrBytes() : Imf::OStream("memory") {}
  void write(const char c[], int n) override {
    const auto size = static_cast<std::size_t>(n);
    if (bytes.size() < position_ + size) bytes.resize(position_ + size);
    std::memcpy(bytes.data() + position_, c, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

  std::vector<std::byte> bytes;

 private:
  std::size_t position_ = 0;
};

}  // namespace welkin::image
