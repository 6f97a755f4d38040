// SPDX-License-Identifier: Apache-2.0
// One writer a folder: a lock that ends with its process, however that ends.
#pragma once

#include <filesystem>
#include <optional>

#include "sky/base/descriptor.h"

namespace welkin::base {

/// The right to write a folder's files, or one numbered part of them. The owner locks bytes of FOLDER/.welkin.lock and
/// writes its name there. An owner of the whole folder removes the file at the end. One that owners of parts or a
/// killed process leave locks nothing. A file system without locks keeps nobody out.
class FolderLock {
 public:
  /// Locks the folder, which must exist: all of it, or one part, >= 0. Owners of different parts work at the same time.
  /// A folder that this process may not write needs no lock, only that nobody writes it. Throws Error(file): "in use
  /// by" with the owner's name, or a refusal of the system.
  explicit FolderLock(const std::filesystem::path& folder, std::optional<int> part = std::nullopt);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Whether this process may not write the folder.
  bool readOnly() const { return read_only_; }

 private:
  std::filesystem::path path_;
  bool whole_;
  Descriptor file_;
  bool read_only_ = false;
};

/// Throws Error(file), "in use by", while a process has a lock on the folder or a part of it.
void requireUnused(const std::filesystem::path& folder);

}  // namespace welkin::base
