// SPDX-License-Identifier: Apache-2.0
// PNG files for tests, chunk by chunk and without compression.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace welkin::tests {

/// A number's bytes from the most significant one.
inline std::string bigEndian(std::uint32_t v, int bytes = 4) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text.push_back(static_cast<char>(v >> (8 * i) & 0xffU));
  return text;
}

/// ISO 3309.
inline std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

/// Zlib's format in one stored block of at most 65535 bytes.
inline std::string stored(const std::string& bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521U;
    b = (b + a) % 65521U;
  }
  const auto size = static_cast<std::uint32_t>(bytes.size());
  const auto little = [](std::uint32_t v) { return std::string{static_cast<char>(v), static_cast<char>(v >> 8U)}; };
  return std::string("\x78\x01\x01", 3) + little(size) + little(~size) + bytes + bigEndian(b << 16U | a);
}

inline std::string chunk(const std::string& name, const std::string& data) {
  return bigEndian(static_cast<std::uint32_t>(data.size())) + name + data + bigEndian(crc32(name + data));
}

/// IHDR's fields as they are given, then the chunks, then rows of codes, which may be empty.
inline std::string pngOf(std::uint32_t width, std::uint32_t height, int bits, int colour_type,
                         const std::vector<std::pair<std::string, std::string>>& chunks,
                         const std::vector<std::string>& rows) {
  std::string texels;
  for (const std::string& row : rows) texels += '\0' + row;
  std::string png = "\x89PNG\r\n\x1a\n";
  png += chunk("IHDR", bigEndian(width) + bigEndian(height) + static_cast<char>(bits) + static_cast<char>(colour_type) +
                           std::string(3, '\0'));
  for (const auto& [name, data] : chunks) png += chunk(name, data);
  return png + chunk("IDAT", stored(texels)) + chunk("IEND", "");
}

}  // namespace welkin::tests
