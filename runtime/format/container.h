// SPDX-License-Identifier: Apache-2.0
// The .welkin container: a 64-byte header that names the format, its version and kind, the file's size and checksum,
// then a FlatBuffer of welkin.fbs. Little-endian; the FlatBuffer starts at byte 64, so a mapped file needs no copy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "welkin_generated.h"

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "Welkin reads little-endian files in place: it has no support for big-endian processors"
#endif

namespace welkin::format {

/// Content of a file. Skies have the number that older files have there.
enum class Kind : std::uint32_t { sky = 0, sector = 1, level = 2 };

/// Version of the container and of the meaning of welkin.fbs, by kind. Files of another version are refused.
inline constexpr std::uint32_t kSkyVersion = 2;
inline constexpr std::uint32_t kLevelVersion = 4;  ///< of sectors and of a level's index
constexpr std::uint32_t versionOf(Kind kind) {
  return kind == Kind::sky ? kSkyVersion : kLevelVersion;
}

/// Name of a kind in messages, such as "a sky".
const char* nameOf(Kind kind);

/// Alignment that openContainer needs of its bytes; a memory map gives more.
inline constexpr std::size_t kAlignment = 16;

/// First bytes of a file. As in PNG, they reveal a transfer that changed line ends or cleared the eighth bit.
inline constexpr unsigned char kMagic[8] = {0x89, 'W', 'L', 'K', '\r', '\n', 0x1a, '\n'};

struct Header {
  unsigned char magic[8];
  std::uint32_t version;
  std::uint32_t header_size;  ///< 64
  std::uint64_t file_size;    ///< bytes, header included
  std::uint64_t checksum;     ///< XXH3-64 of the whole file with this field 0
  Kind kind;
  unsigned char reserved[28];  ///< 0
};
static_assert(sizeof(Header) == 64 && offsetof(Header, checksum) == 24);

/// Why a container was refused.
enum class Refusal { none, misaligned, foreign, version, truncated, checksum, structure, header, kind };

struct Opened {
  Refusal refusal = Refusal::none;
  const File* file = nullptr;  ///< points into the bytes; null when refused
  Kind kind = Kind::sky;       ///< as the header says
  std::uint32_t found_version = 0;
  std::uint32_t found_header_size = 0;
  std::uint64_t expected_size = 0;  ///< file size by the header; the header's own size if the bytes end before it
};

/// Checks header, size, checksum and the structure of the FlatBuffer (every offset inside the bytes). Takes O(size) and
/// does not allocate. The meaning of the values is not checked.
Opened openContainer(std::span<const std::byte> bytes);

/// XXH3-128 of a whole file, by which the index of a level names its files.
Hash hashOf(std::span<const std::byte> bytes);

/// The kind that the header at the front of `bytes` names; none for bytes that are not a header.
std::optional<Kind> kindOf(std::span<const std::byte> bytes);

/// Puts the header before a finished FlatBuffer.
std::vector<std::byte> seal(std::span<const std::uint8_t> flatbuffer, Kind kind = Kind::sky);

}  // namespace welkin::format
