// SPDX-License-Identifier: Apache-2.0
// File mapping by Windows.
#include "core/file_map.h"

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX  // MinGW's libstdc++ defines it
#define NOMINMAX
#endif
#include <windows.h>

#include <cstdio>
#include <memory>
#include <new>

namespace welkin::core {
namespace {

/// Closes a handle at the end of a scope.
struct Handle {
  HANDLE value;
  explicit Handle(HANDLE opened) : value(opened) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (isOpen()) CloseHandle(value);
  }
  bool isOpen() const { return value != nullptr && value != INVALID_HANDLE_VALUE; }
};

int lastError() {
  return static_cast<int>(GetLastError());
}

}  // namespace

FileMap::~FileMap() {
  if (!bytes_.empty()) UnmapViewOfFile(bytes_.data());
}

int FileMap::open(const char* path) {
  const int length = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, nullptr, 0);
  if (length <= 0) return lastError();
  const std::unique_ptr<wchar_t[]> wide(new (std::nothrow) wchar_t[static_cast<std::size_t>(length)]);
  if (wide == nullptr) return ERROR_NOT_ENOUGH_MEMORY;
  MultiByteToWideChar(CP_UTF8, 0, path, -1, wide.get(), length);
  const Handle file(CreateFileW(wide.get(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
                                FILE_ATTRIBUTE_NORMAL, nullptr));
  if (!file.isOpen()) return lastError();
  if (GetFileType(file.value) != FILE_TYPE_DISK) return ERROR_BAD_FILE_TYPE;  // a pipe or a console
  LARGE_INTEGER size{};
  if (GetFileSizeEx(file.value, &size) == 0) return lastError();
  if (size.QuadPart == 0) return 0;
  const Handle mapping(CreateFileMappingW(file.value, nullptr, PAGE_READONLY, 0, 0, nullptr));
  if (!mapping.isOpen()) return lastError();
  const void* address = MapViewOfFile(mapping.value, FILE_MAP_READ, 0, 0, 0);
  if (address == nullptr) return lastError();
  bytes_ = {static_cast<const std::byte*>(address), static_cast<std::size_t>(size.QuadPart)};
  return 0;
}

void FileMap::describe(int error, char* text, std::size_t size) {
  const DWORD length = FormatMessageA(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr,
                                      static_cast<DWORD>(error), 0, text, static_cast<DWORD>(size), nullptr);
  if (length == 0) std::snprintf(text, size, "error %d of Windows", error);
  for (std::size_t end = length; end > 0 && (text[end - 1] == '\n' || text[end - 1] == '\r'); --end) text[end - 1] = 0;
}

}  // namespace welkin::core
