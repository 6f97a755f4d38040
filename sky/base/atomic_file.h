// SPDX-License-Identifier: Apache-2.0
// Files that are there whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace welkin::base {

/// Writes the bytes to `path`.tmp, flushes them to the device and renames; on failure removes what it wrote and throws
/// Error(ExitStatus::file). A file that holds these bytes already is left untouched, its date included. What a killed
/// run left at `path`.tmp goes. A device or a pipe is written where it is.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& path, std::string_view text);

/// Reads a whole regular file; throws Error(ExitStatus::file) naming it, or when it is larger than `limit` bytes
/// Error(ExitStatus::content).
std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 32);

/// The first bytes of a regular file, `most` or fewer; throws Error(ExitStatus::file) naming it.
std::vector<std::byte> readStart(const std::filesystem::path& path, std::size_t most);

/// Makes a folder and its parents; throws Error(ExitStatus::file).
void makeFolder(const std::filesystem::path& path);

}  // namespace welkin::base
