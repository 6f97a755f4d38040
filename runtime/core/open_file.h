// SPDX-License-Identifier: Apache-2.0
// The bytes of a .welkin file that a caller names, checked up to the structure of their FlatBuffer.
#pragma once

#include <welkin/welkin.h>

#include <cstddef>
#include <span>

#include "core/file_map.h"
#include "core/host_memory.h"
#include "format/container.h"

namespace welkin::core {

/// Bytes of a file, and the memory that they lie in unless that is the caller's.
struct FileBytes {
  HostMemory memory;
  FileMap map;
  HostArray<std::byte> copy;
  std::span<const std::byte> bytes;
};

/// WELKIN_OK if `info`, which `sized` has checked, names one source and complete callbacks.
WelkinResult checkOpenInfo(const char* function, const WelkinOpenInfo& info);

/// Maps, copies or borrows the bytes that `info` names. `message` gets the reason without the path.
WelkinResult readBytes(const WelkinOpenInfo& info, FileBytes& file, WelkinMessage* message);

/// The root of a file of the wanted kind. An error names another kind, version or damage.
WelkinResult rootOf(std::span<const std::byte> bytes, format::Kind wanted, const format::File** root,
                    WelkinMessage* message);

/// Ends a call that opens a file. On an error it fills `message` with the path and the `reason`, and logs it.
WelkinResult endOpen(const char* function, const WelkinOpenInfo& info, WelkinResult result, const WelkinMessage& reason,
                     WelkinMessage* message);

}  // namespace welkin::core
