// SPDX-License-Identifier: Apache-2.0
#include "core/open_file.h"

#include <cstdio>
#include <cstring>

#include "core/arguments.h"

namespace welkin::core {
namespace {

/// Such as "a sky is needed (sky.welkin)".
const char* needOf(format::Kind kind) {
  switch (kind) {
    case format::Kind::sky:
      return "a sky is needed (sky.welkin)";
    case format::Kind::sector:
      return "a sector is needed (sectors/sector_X_Z.welkin)";
    case format::Kind::level:
      return "the index of a level is needed (level.welkin)";
  }
  return "";
}

}  // namespace

WelkinResult checkOpenInfo(const char* function, const WelkinOpenInfo& info) {
  if ((info.path != nullptr) == (info.data != nullptr))
    return refuse(function, info.path != nullptr ? "info has both path and data" : "path and data are null");
  if (info.flags > WELKIN_OPEN_COPY) return refuse(function, "info->flags is %u, must be 0 or 1", info.flags);
  if (info.allocator != nullptr) {
    if (const auto r = sized(function, "info->allocator", info.allocator)) return r;
    if (const auto r = nonNull(function, {{"info->allocator->allocate", asPointer(info.allocator->allocate)},
                                          {"info->allocator->free", asPointer(info.allocator->free)}}))
      return r;
  }
  if (info.log == nullptr) return WELKIN_OK;
  if (const auto r = sized(function, "info->log", info.log)) return r;
  return nonNull(function, {{"info->log->write", asPointer(info.log->write)}});
}

WelkinResult readBytes(const WelkinOpenInfo& info, FileBytes& file, WelkinMessage* message) {
  if (info.allocator != nullptr) file.memory = HostMemory(take(*info.allocator));
  file.bytes = {static_cast<const std::byte*>(info.data), info.size};
  if (info.path != nullptr) {
    if (const int error = file.map.open(info.path); error != 0) {
      if (message != nullptr) FileMap::describe(error, message->text, sizeof message->text);
      return WELKIN_ERROR_FILE;
    }
    file.bytes = file.map.bytes();
  }
  if ((info.flags & WELKIN_OPEN_COPY) != 0 && !file.bytes.empty()) {
    if (!file.copy.allocate(file.memory, file.bytes.size())) return fail(message, WELKIN_ERROR_MEMORY, "out of memory");
    std::memcpy(file.copy.get(), file.bytes.data(), file.bytes.size());
    file.bytes = {file.copy.get(), file.bytes.size()};
    file.map = FileMap();
  }
  return WELKIN_OK;
}

WelkinResult rootOf(std::span<const std::byte> bytes, format::Kind wanted, const format::File** root,
                    WelkinMessage* message) {
  using format::Refusal;
  const format::Opened container = format::openContainer(bytes);
  const auto expected = static_cast<unsigned long long>(container.expected_size);
  switch (container.refusal) {
    case Refusal::none:
      if (container.kind != wanted)
        return fail(message, WELKIN_ERROR_KIND, "this is %s; %s", nameOf(container.kind), needOf(wanted));
      *root = container.file;
      return WELKIN_OK;
    case Refusal::misaligned:
      return fail(message, WELKIN_ERROR_ARGUMENT, "the bytes start at %p; they must be aligned to %zu",
                  static_cast<const void*>(bytes.data()), format::kAlignment);
    case Refusal::foreign:
      return fail(message, WELKIN_ERROR_FOREIGN, "not a .welkin file (it does not start with the .welkin signature)");
    case Refusal::kind:
      return fail(message, WELKIN_ERROR_KIND, "a .welkin file of kind %u, which this library does not know",
                  static_cast<unsigned>(container.kind));
    case Refusal::version:
      if (container.kind != wanted)
        return fail(message, WELKIN_ERROR_KIND, "this is %s, of format version %u; %s", nameOf(container.kind),
                    container.found_version, needOf(wanted));
      return fail(message, WELKIN_ERROR_VERSION, "format version %u; this library reads version %u: %s",
                  container.found_version, format::versionOf(wanted),
                  container.found_version > format::versionOf(wanted) ? "it is older than the file" : "bake again");
    case Refusal::header:
      return fail(message, WELKIN_ERROR_CONTENT, "damaged: its header states a size of %u bytes, must be %zu",
                  container.found_header_size, sizeof(format::Header));
    case Refusal::truncated:
      return fail(message, WELKIN_ERROR_TRUNCATED, "%zu bytes; the header asks for %s%llu", bytes.size(),
                  bytes.size() < sizeof(format::Header) ? "at least " : "", expected);
    case Refusal::checksum:
      return fail(message, WELKIN_ERROR_CHECKSUM, "damaged: the checksum of its %zu bytes does not match",
                  bytes.size());
    case Refusal::structure:
      break;
  }
  return fail(message, WELKIN_ERROR_CONTENT, "damaged: an offset or length of its tables is out of bounds");
}

WelkinResult endOpen(const char* function, const WelkinOpenInfo& info, WelkinResult result, const WelkinMessage& reason,
                     WelkinMessage* message) {
  if (result == WELKIN_OK) return result;
  if (result == WELKIN_ERROR_ARGUMENT) refuse(function, "%s", reason.text);
  WelkinMessage whole{};
  if (info.path != nullptr)
    std::snprintf(whole.text, sizeof whole.text, "%.140s: %.112s", info.path, reason.text);
  else
    whole = reason;
  if (info.log != nullptr) info.log->write(info.log->user, WELKIN_LOG_ERROR, whole.text);
  return fail(message, result, "%s", whole.text);
}

}  // namespace welkin::core
