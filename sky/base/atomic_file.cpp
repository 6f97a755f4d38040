// SPDX-License-Identifier: Apache-2.0
#include "sky/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sky/base/descriptor.h"
#include "sky/base/error.h"

namespace welkin::base {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* verb, int error) {
  throw Error(ExitStatus::file, fmt::format("{}: cannot {}: {}", path.string(), verb, std::strerror(error)));
}

/// Whether the file holds exactly these bytes.
bool holds(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (file.fd < 0 || fstat(file.fd, &status) != 0 || !S_ISREG(status.st_mode) ||
      static_cast<std::size_t>(status.st_size) != bytes.size())
    return false;
  std::byte block[65536];
  while (!bytes.empty()) {
    const ssize_t n = ::read(file.fd, block, std::min(sizeof block, bytes.size()));
    if (n <= 0 || std::memcmp(block, bytes.data(), static_cast<std::size_t>(n)) != 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

int writeAll(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = uninterrupted([&] { return ::write(fd, bytes.data(), bytes.size()); });
    if (n <= 0) return n < 0 ? errno : EIO;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return uninterrupted([&] { return ::fsync(fd); }) != 0 && errno != EINVAL ? errno : 0;  // EINVAL: a device
}

bool isDevice(const std::filesystem::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Writes into /dev/stdout, a pipe and the like: a rename would put a file in the device's place.
void writeDevice(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  Descriptor device(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe that nobody reads is an error
  if (device.fd < 0 || ::fcntl(device.fd, F_SETFL, 0) != 0) refuse(path, "write", errno);
  if (const int error = writeAll(device.fd, bytes); error != 0) refuse(path, "write", error);
}

Descriptor openRegular(const std::filesystem::path& path, struct stat& status) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.fd < 0) refuse(path, "read", errno);
  if (fstat(file.fd, &status) != 0) refuse(path, "read", errno);
  if (!S_ISREG(status.st_mode)) refuse(path, "read", S_ISDIR(status.st_mode) ? EISDIR : EINVAL);
  return file;
}

std::vector<std::byte> readUpTo(int fd, std::size_t most, const std::filesystem::path& path) {
  std::vector<std::byte> bytes(most);
  std::size_t done = 0;
  while (done < most) {
    const ssize_t n = uninterrupted([&] { return ::read(fd, bytes.data() + done, most - done); });
    if (n < 0) refuse(path, "read", errno);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

constexpr ByteRange kWhole;
constexpr int kMostNameAttempts = 1000;

std::filesystem::path temporaryPath(const std::filesystem::path& path, int number) {
  std::filesystem::path temporary = path;
  temporary += number == 0 ? ".tmp" : fmt::format(".{}.tmp", number);
  return temporary;
}

/// Removes a temporary file that no process writes any more, or a link in its place. Returns whether it is gone.
bool removeLeftover(const std::filesystem::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return errno == ENOENT;
  if (S_ISLNK(status.st_mode)) return ::unlink(path.c_str()) == 0;
  if (!S_ISREG(status.st_mode)) return false;
  const Descriptor file(
      uninterrupted([&] { return ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC); }));
  // The owner of the lock, if it finds the file in its place, is the only one to move it.
  return file.fd >= 0 && lockRange(file, kWhole) == Locked::yes && isAt(file, path) && ::unlink(path.c_str()) == 0;
}

/// A new file beside `path`, locked as long as it is being written.
struct Temporary {
  std::filesystem::path path;
  Descriptor file;
  Descriptor lock;  ///< a copy of `file`, which is closed before the file gets its name
};

Temporary makeTemporary(const std::filesystem::path& path) {
  int number = 0;
  for (int attempt = 0; attempt < kMostNameAttempts; ++attempt) {
    Temporary made{temporaryPath(path, number), Descriptor(), Descriptor()};
    made.file = Descriptor(uninterrupted(
        [&] { return ::open(made.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666); }));
    if (made.file.fd < 0) {
      if (errno != EEXIST) refuse(path, "write", errno);
      if (!removeLeftover(made.path)) ++number;
      continue;
    }
    made.lock = Descriptor(::fcntl(made.file.fd, F_DUPFD_CLOEXEC, 0));
    if (made.lock.fd < 0) {
      const int error = errno;
      ::unlink(made.path.c_str());
      refuse(path, "write", error);
    }
    waitForRange(made.lock, kWhole);
    if (isAt(made.lock, made.path)) return made;  // else it was taken for a leftover before it was locked
  }
  refuse(path, "write", EEXIST);
}

/// Makes names in a folder last through a loss of power.
void syncFolder(const std::filesystem::path& folder) {
  const Descriptor opened(
      uninterrupted([&] { return ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
  if (opened.fd < 0) return;  // a folder that may be written and not read
  if (uninterrupted([&] { return ::fsync(opened.fd); }) != 0 && errno != EINVAL) refuse(folder, "write", errno);
}

}  // namespace

void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  if (isDevice(path)) return writeDevice(path, bytes);
  if (holds(path, bytes)) {
    removeLeftover(temporaryPath(path, 0));
    return;
  }
  Temporary temporary = makeTemporary(path);
  int error = writeAll(temporary.file.fd, bytes);
  if (const int at_close = temporary.file.close(); error == 0) error = at_close;
  if (error == 0 && ::rename(temporary.path.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.path.c_str());
    refuse(path, "write", error);
  }
  syncFolder(path.parent_path());
}

void writeFile(const std::filesystem::path& path, std::string_view text) {
  writeFile(path, std::as_bytes(std::span(text.data(), text.size())));
}

std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t limit) {
  struct stat status {};
  const Descriptor file = openRegular(path, status);
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > limit)
    throw Error(ExitStatus::content, fmt::format("{}: {} bytes; at most {} are allowed", path.string(), size, limit));
  return readUpTo(file.fd, size, path);
}

std::vector<std::byte> readStart(const std::filesystem::path& path, std::size_t most) {
  struct stat status {};
  const Descriptor file = openRegular(path, status);
  return readUpTo(file.fd, most, path);
}

void requireSize(const std::filesystem::path& path, std::uint64_t bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
      static_cast<std::uint64_t>(status.st_size) == bytes)
    return;
  throw Error(
      ExitStatus::file,
      fmt::format("{}: something else has removed or changed it since it was written; bake again", path.string()));
}

void requireNoInput(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs) {
  std::error_code none;
  for (const std::filesystem::path& input : inputs)
    if (!input.empty() && std::filesystem::equivalent(output, input, none))
      throw Error(ExitStatus::usage,
                  fmt::format("{} is an input and would be overwritten; name another folder", output.string()));
}

void makeFolder(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return;
  if (path.has_parent_path() && path.parent_path() != path) makeFolder(path.parent_path());
  const bool made = std::filesystem::create_directory(path, error);
  if (error || !std::filesystem::is_directory(path, error))
    throw Error(ExitStatus::file, fmt::format("{}: cannot make the folder: {}", path.string(),
                                              error ? error.message() : "a file is in the way"));
  if (made) syncFolder(path.parent_path());
}

}  // namespace welkin::base
