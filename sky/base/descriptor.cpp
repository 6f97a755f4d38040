// SPDX-License-Identifier: Apache-2.0
#include "sky/base/descriptor.h"

#include <sys/stat.h>

namespace welkin::base {
namespace {

// Locks of open file descriptions (fcntl(2), "OFD"). Those of processes (F_SETLK) would not keep two threads apart, and
// they end when the process closes any descriptor of the file.
Locked lock(const Descriptor& file, ByteRange range, int command) {
  struct flock wanted {};
  wanted.l_type = F_WRLCK;
  wanted.l_whence = SEEK_SET;
  wanted.l_start = range.start;
  wanted.l_len = range.length;
  if (uninterrupted([&] { return ::fcntl(file.fd, command, &wanted); }) == 0) return Locked::yes;
  return errno == EAGAIN || errno == EACCES ? Locked::no : Locked::unavailable;
}

}  // namespace

Locked lockRange(const Descriptor& file, ByteRange range) {
  return lock(file, range, F_OFD_SETLK);
}

Locked waitForRange(const Descriptor& file, ByteRange range) {
  return lock(file, range, F_OFD_SETLKW);
}

off_t lockedStart(const Descriptor& file, ByteRange range) {
  struct flock found {};
  found.l_type = F_RDLCK;
  found.l_whence = SEEK_SET;
  found.l_start = range.start;
  found.l_len = range.length;
  if (::fcntl(file.fd, F_OFD_GETLK, &found) != 0 || found.l_type == F_UNLCK) return -1;
  return found.l_start;
}

bool isAt(const Descriptor& file, const std::filesystem::path& path) {
  // It is opened, as NFS asks the server at open() and may answer stat() from memory.
  const Descriptor now(
      uninterrupted([&] { return ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK); }));
  struct stat a {};
  struct stat b {};
  return now.fd >= 0 && ::fstat(file.fd, &a) == 0 && ::fstat(now.fd, &b) == 0 && a.st_dev == b.st_dev &&
         a.st_ino == b.st_ino;
}

}  // namespace welkin::base
