// SPDX-License-Identifier: Apache-2.0
#include "sky/base/folder_lock.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstring>
#include <string>

#include "sky/base/error.h"

namespace welkin::base {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kName = 64;  // bytes of an owner's name; a part's name and its lock have the same bytes
constexpr ByteRange kAll;
constexpr int kMostLockAttempts = 1000;

fs::path lockPath(const fs::path& folder) {
  return folder / ".welkin.lock";
}

[[noreturn]] void refuse(const fs::path& path, int error) {
  throw Error(ExitStatus::file, fmt::format("{}: cannot lock: {}", path.string(), std::strerror(error)));
}

void writeName(const Descriptor& file, off_t start) {
  char host[kName]{};
  ::gethostname(host, sizeof host - 1);
  std::string name = fmt::format("process {} on {}", ::getpid(), host);
  name.resize(kName);
  if (::pwrite(file.fd, name.data(), name.size(), start) < 0) return;  // then the owner has no name
}

/// The owner's name as it stands in the file, without any byte that a terminal could take for a command.
std::string readName(const Descriptor& file, off_t start) {
  char bytes[kName]{};
  if (::pread(file.fd, bytes, sizeof bytes, start) < 0) bytes[0] = '\0';
  std::string name;
  for (const char c : bytes)
    if (c >= ' ' && c <= '~') name += c;
  return name.empty() ? "another process" : name;
}

[[noreturn]] void refuseInUse(const fs::path& folder, const Descriptor& file, off_t start) {
  throw Error(ExitStatus::file,
              fmt::format("{}: in use by {}; try again when it has ended", folder.string(), readName(file, start)));
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, std::optional<int> part) : path_(lockPath(folder)), whole_(!part) {
  const ByteRange range = part ? ByteRange{*part * static_cast<off_t>(kName), kName} : kAll;
  for (int attempt = 0; attempt < kMostLockAttempts; ++attempt) {
    Descriptor file(uninterrupted(
        [&] { return ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666); }));
    if (file.fd < 0) {
      const int error = errno;
      if (error == ENOENT || error == ENOTDIR) refuse(folder, error);
      const bool denied = error == EROFS || error == EACCES || error == EPERM;
      if (!denied || ::access(folder.c_str(), W_OK) == 0) refuse(path_, error);
      requireUnused(folder);
      read_only_ = true;
      return;
    }
    struct stat status {};
    if (::fstat(file.fd, &status) != 0) refuse(path_, errno);
    if (!S_ISREG(status.st_mode) || status.st_nlink > 1) refuse(path_, EEXIST);  // nobody's lock: it is not written
    const Locked locked = lockRange(file, range);
    if (locked == Locked::no) {
      const off_t start = lockedStart(file, range);
      if (start < 0) continue;  // it has ended since
      refuseInUse(folder, file, start);
    }
    if (!isAt(file, path_)) continue;  // its owner has removed it since it was opened
    writeName(file, range.start);
    file_ = std::move(file);
    return;
  }
  refuse(path_, EAGAIN);
}

FolderLock::~FolderLock() {
  if (file_.fd >= 0 && whole_ && isAt(file_, path_)) ::unlink(path_.c_str());
}

void requireUnused(const fs::path& folder) {
  const Descriptor file(
      uninterrupted([&] { return ::open(lockPath(folder).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC); }));
  if (file.fd < 0) return;
  const off_t start = lockedStart(file, kAll);
  if (start >= 0) refuseInUse(folder, file, start);
}

}  // namespace welkin::base
