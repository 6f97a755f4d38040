// SPDX-License-Identifier: Apache-2.0
// Files outside of a level's folder. A level may come from others, and name any file of the machine.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sky/base/error.h"

namespace welkin::level {

/// How a level treats them: `warn`, `allow` or `refuse` ([level] outside_files).
enum class OutsideFiles { warn, allow, refuse };

/// The files that are not below `folder`, links followed: each once, in their order. None if `folder` is empty.
std::vector<std::filesystem::path> filesOutside(const std::filesystem::path& folder,
                                                const std::vector<std::filesystem::path>& files);

/// A message about them, with the names of the first ones. `files` is not empty.
std::string outsideText(const std::vector<std::filesystem::path>& files);

/// Throws Error(content) if any of the files is outside of the folder.
void requireInside(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files);

/// Throws the error again. One of status `content` loses its words where files outside of the folder were read, since
/// they might show the files' bytes; it then names `path` and those files.
[[noreturn]] void throwWithoutBytes(const base::Error& error, const std::filesystem::path& path,
                                    const std::filesystem::path& folder,
                                    const std::vector<std::filesystem::path>& files);

/// Warnings of OBJ and MTL files name keywords that are not read: "FILE: not read: word (line 1)". From the `first` on,
/// those of files outside of the folder lose the words.
void leaveOutWords(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& files,
                   std::vector<std::string>& warnings, std::size_t first);

}  // namespace welkin::level
