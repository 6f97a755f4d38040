// SPDX-License-Identifier: Apache-2.0
#include "sky/base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "sky/base/error.h"

namespace welkin::base {
namespace {

/// A file descriptor that closes on destruction.
struct Descriptor {
  int fd;
  explicit Descriptor(int fd_) : fd(fd_) {}
  Descriptor(Descriptor&& other) noexcept : fd(std::exchange(other.fd, -1)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  /// Returns 0 or the error. After EINTR the file is closed all the same (Linux).
  int close() { return ::close(std::exchange(fd, -1)) != 0 && errno != EINTR ? errno : 0; }
};

/// Repeats a system call as long as signals interrupt it.
template <typename Call>
auto uninterrupted(const Call& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

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

}  // namespace

void writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  if (isDevice(path)) return writeDevice(path, bytes);
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  if (holds(path, bytes)) {
    ::unlink(temporary.c_str());  // Left by a run that was killed.
    return;
  }
  Descriptor file(
      uninterrupted([&] { return ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666); }));
  if (file.fd < 0) refuse(path, "write", errno);
  int error = writeAll(file.fd, bytes);
  if (const int at_close = file.close(); error == 0) error = at_close;
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    refuse(path, "write", error);
  }
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

void makeFolder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path, error))
    throw Error(ExitStatus::file, fmt::format("{}: cannot make the folder: {}", path.string(),
                                              error ? error.message() : "a file is in the way"));
}

}  // namespace welkin::base
