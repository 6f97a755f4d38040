// SPDX-License-Identifier: Apache-2.0
// libFuzzer's mutator of images. In seven inputs of eight a PNG's chunks get the checksums of their new bytes, so that
// the input reaches the code behind the checksums. The other formats have none.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t size, std::size_t most);

namespace {

constexpr std::size_t kSignature = 8;
constexpr std::size_t kFrame = 12;  // length, type, checksum

/// CRC-32 of ISO 3309, computed as in PNG's annex D.
std::uint32_t crc32(const std::uint8_t* bytes, std::size_t size) {
  static const auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      table[n] = n;
      for (int bit = 0; bit < 8; ++bit) table[n] = (table[n] >> 1) ^ ((table[n] & 1) != 0 ? 0xedb88320U : 0U);
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffU;
  for (std::size_t i = 0; i < size; ++i) crc = kTable[(crc ^ bytes[i]) & 0xffU] ^ (crc >> 8);
  return ~crc;
}

std::uint32_t load(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | std::uint32_t{p[3]};
}

void forgeChecksums(std::uint8_t* bytes, std::size_t size) {
  for (std::size_t at = kSignature; at + kFrame <= size;) {
    const std::size_t length = load(bytes + at);
    if (length > size - at - kFrame) return;
    const std::uint32_t crc = crc32(bytes + at + 4, length + 4);
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
    at += length + kFrame;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t size, std::size_t most, unsigned seed) {
  size = LLVMFuzzerMutate(bytes, size, most);
  if (size > kSignature && std::memcmp(bytes, "\x89PNG", 4) == 0 && seed % 8 != 0) forgeChecksums(bytes, size);
  return size;
}
