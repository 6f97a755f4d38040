// SPDX-License-Identifier: Apache-2.0
// File descriptors that close themselves, and locks on ranges of a file's bytes.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <utility>

namespace welkin::base {

/// A file descriptor that closes on destruction.
struct Descriptor {
  int fd;
  explicit Descriptor(int fd_ = -1) : fd(fd_) {}
  Descriptor(Descriptor&& other) noexcept : fd(std::exchange(other.fd, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd, other.fd);
    return *this;
  }
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

/// Bytes of a file. They need not exist. A length of 0 reaches to infinity.
struct ByteRange {
  off_t start = 0;
  off_t length = 0;
};

enum class Locked {
  yes,
  no,          ///< another descriptor has locked a part of the range
  unavailable  ///< the file system has no locks
};

/// Locks bytes of a file that is open for writing, against every other descriptor of this or another process. The lock
/// ends with the last copy of the descriptor, however the process ends. NFS passes it on to its server.
Locked lockRange(const Descriptor& file, ByteRange range);
/// The same, but waits while another descriptor has the lock.
Locked waitForRange(const Descriptor& file, ByteRange range);

/// The start of a range that another descriptor has locked for writing; -1 if there is none.
off_t lockedStart(const Descriptor& file, ByteRange range);

/// Whether the path still leads to the open file, and not to another one or none.
bool isAt(const Descriptor& file, const std::filesystem::path& path);

}  // namespace welkin::base
