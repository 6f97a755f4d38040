// SPDX-License-Identifier: Apache-2.0
// Writes files that appear whole or not at all, and reads files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace welkin::base {

/// Writes the bytes to a new file, flushes it to the device, renames it to `path` and flushes the folder. The new file
/// is `path`.tmp, or `path`.N.tmp while another process writes the former; one left by a killed process is removed,
/// and no link is followed. On failure it removes its temporary file and throws Error(ExitStatus::file). A file that
/// already holds these bytes is left untouched, its date included. A device or a pipe is written in place.
void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFile(const std::filesystem::path& path, std::string_view text);

/// Reads a whole regular file. Throws Error(ExitStatus::file) naming the file, or Error(ExitStatus::content) when it is
/// larger than `limit` bytes.
std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t limit = std::size_t{1} << 32);

/// Reads the first bytes of a regular file, at most `most`. Throws Error(ExitStatus::file) naming the file.
std::vector<std::byte> readStart(const std::filesystem::path& path, std::size_t most);

/// Throws Error(ExitStatus::file) unless a regular file of so many bytes is there, as was written before.
void requireSize(const std::filesystem::path& path, std::uint64_t bytes);

/// Throws Error(ExitStatus::usage) where the output would take the place of an input.
void requireNoInput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs);

/// Makes a folder and its parents; throws Error(ExitStatus::file).
void makeFolder(const std::filesystem::path& path);

}  // namespace welkin::base
