// SPDX-License-Identifier: Apache-2.0
#include "format/container.h"

#include <cstring>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace welkin::format {
namespace {

std::uint64_t checksumOf(const Header& header, std::span<const std::byte> payload) {
  Header blank = header;
  blank.checksum = 0;
  XXH3_state_t state;
  XXH3_64bits_reset(&state);
  XXH3_64bits_update(&state, &blank, sizeof blank);
  XXH3_64bits_update(&state, payload.data(), payload.size());
  return XXH3_64bits_digest(&state);
}

}  // namespace

const char* nameOf(Kind kind) {
  switch (kind) {
    case Kind::sky:
      return "a sky";
    case Kind::sector:
      return "a sector of a level";
    case Kind::level:
      return "the index of a level";
  }
  return "of an unknown kind";
}

Hash hashOf(std::span<const std::byte> bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {hash.low64, hash.high64};
}

std::optional<Kind> kindOf(std::span<const std::byte> bytes) {
  if (bytes.size() < sizeof(Header) || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0) return std::nullopt;
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  return header.kind <= Kind::level ? std::optional(header.kind) : std::nullopt;
}

Opened openContainer(std::span<const std::byte> bytes) {
  Opened result;
  const auto refuse = [&](Refusal why) {
    result.refusal = why;
    return result;
  };
  if (reinterpret_cast<std::uintptr_t>(bytes.data()) % kAlignment != 0) return refuse(Refusal::misaligned);
  const std::size_t comparable = bytes.size() < sizeof kMagic ? bytes.size() : sizeof kMagic;
  if (comparable == 0 || std::memcmp(bytes.data(), kMagic, comparable) != 0) return refuse(Refusal::foreign);
  result.expected_size = sizeof(Header);
  if (bytes.size() < sizeof(Header)) return refuse(Refusal::truncated);
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  result.found_version = header.version;
  result.found_header_size = header.header_size;
  result.kind = header.kind;
  if (header.kind > Kind::level) return refuse(Refusal::kind);
  if (header.version != versionOf(header.kind)) return refuse(Refusal::version);
  if (header.header_size != sizeof(Header)) return refuse(Refusal::header);
  result.expected_size = header.file_size;
  if (header.file_size != bytes.size()) return refuse(Refusal::truncated);
  const auto payload = bytes.subspan(sizeof header);
  if (checksumOf(header, payload) != header.checksum) return refuse(Refusal::checksum);
  flatbuffers::Verifier verifier(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size());
  if (!VerifyFileBuffer(verifier)) return refuse(Refusal::structure);
  const File* file = GetFile(payload.data());
  if (header.kind == Kind::sky && file->sky() == nullptr && (file->sector() != nullptr || file->level() != nullptr)) {
    result.kind = file->sector() != nullptr ? Kind::sector : Kind::level;  // of version 2, which named no kind
    return refuse(Refusal::version);
  }
  result.file = file;
  return result;
}

std::vector<std::byte> seal(std::span<const std::uint8_t> flatbuffer, Kind kind) {
  Header header{};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  header.version = versionOf(kind);
  header.header_size = sizeof(Header);
  header.file_size = sizeof(Header) + flatbuffer.size();
  header.kind = kind;
  header.checksum = checksumOf(header, std::as_bytes(flatbuffer));
  std::vector<std::byte> bytes(sizeof(Header) + flatbuffer.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  if (!flatbuffer.empty()) std::memcpy(bytes.data() + sizeof header, flatbuffer.data(), flatbuffer.size());
  return bytes;
}

}  // namespace welkin::format
