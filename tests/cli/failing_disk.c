/* SPDX-License-Identifier: Apache-2.0
 *
 * A disk that fails, for LD_PRELOAD. It counts the calls that change files, from 1: open() for writing; write(),
 * fsync() and close() of such files; fsync() of folders; rename(), mkdir(), unlink() and remove().
 * WELKIN_DISK_NO_LOCKS=1 a file system without locks. WELKIN_DISK_BYTES=N  N bytes of room: the first write() that does
 * not fit is cut, the next fails with ENOSPC WELKIN_DISK_FAULT=F  the call WELKIN_DISK_CALL fails with the error F:
 * ENOSPC, EIO, EDQUOT, EROFS, EPERM; or EINTR  open(), write(), fsync() or close() is interrupted (only these are
 * counted then) short  write() writes a third of its bytes kill   the process kills itself before the call, or in the
 * middle of a write() WELKIN_DISK_CALL=K   number of the call that fails; "K+": all later calls fail too, with EINTR
 * every second one WELKIN_DISK_LOG=P    adds a line to this file for each call that succeeded: its name and its paths
 * unlink() and remove() are counted only with kill and with "K+", so that a failed write can be cleaned up. There is no
 * lock: the program must not make these calls at the same time. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#define API __attribute__((visibility("default")))
enum { kMostFiles = 1024, kShort = -1, kKill = -2 };

static long room = -1; /* bytes; below 0: no limit */
static int fault = 0;  /* an error number, kShort, kKill; 0: none */
static long at = 0;    /* number of the call that fails */
static int stays = 0;  /* whether later calls fail too */
static long calls = 0; /* number of calls so far */
static int log_file = -1;
static char* path_of[kMostFiles]; /* by file descriptor, of files opened for writing, and of folders */
static char is_folder[kMostFiles];

static __attribute__((constructor)) void readEnvironment(void) {
  static const struct {
    const char* name;
    int fault;
  } kFaults[] = {{"ENOSPC", ENOSPC}, {"EIO", EIO},     {"EDQUOT", EDQUOT}, {"EROFS", EROFS},
                 {"EPERM", EPERM},   {"EINTR", EINTR}, {"short", kShort},  {"kill", kKill}};
  const char* text = getenv("WELKIN_DISK_BYTES");
  if (text != NULL) room = atol(text);
  text = getenv("WELKIN_DISK_FAULT");
  for (size_t i = 0; text != NULL && i < sizeof kFaults / sizeof *kFaults; ++i)
    if (strcmp(text, kFaults[i].name) == 0) fault = kFaults[i].fault;
  text = getenv("WELKIN_DISK_CALL");
  if (text != NULL) {
    at = atol(text);
    stays = strchr(text, '+') != NULL;
  }
  text = getenv("WELKIN_DISK_LOG");
  if (text != NULL)
    log_file = (int)syscall(SYS_openat, AT_FDCWD, text, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
}

/* Counts a call and returns whether it must fail. */
static int fails(void) {
  const long call = ++calls;
  if (fault == 0 || call < at) return 0;
  if (call > at && (!stays || (fault == EINTR && (call - at) % 2 != 0))) return 0;
  if (fault == kKill) return 1;
  if (fault > 0) errno = fault;
  return 1;
}

static long killed(void) {
  raise(SIGKILL);
  return -1;
}

/* Whether a call that is done whole or not at all must fail. */
static int refused(int interruptible) {
  if (fault == EINTR && !interruptible) return 0;
  if (!fails() || fault == kShort) return 0;
  if (fault == kKill) killed();
  return 1;
}

static void note(const char* call, const char* a, const char* b) {
  if (log_file < 0) return;
  char line[8192];
  size_t n = 0;
  const char* parts[] = {call, " ", a, b != NULL ? " " : "", b != NULL ? b : "", "\n"};
  for (size_t i = 0; i < sizeof parts / sizeof *parts; ++i)
    for (const char* c = parts[i]; *c != '\0' && n < sizeof line; ++c) line[n++] = *c;
  syscall(SYS_write, log_file, line, n);
}

static const char* pathOf(int fd) {
  return fd >= 0 && fd < kMostFiles ? path_of[fd] : NULL;
}

API int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list arguments;
    va_start(arguments, flags);
    mode = va_arg(arguments, mode_t);
    va_end(arguments);
  }
  const int writes = (flags & O_ACCMODE) != O_RDONLY;
  if (writes && refused(1)) return -1;
  const int fd = (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
  const int folder = (flags & O_DIRECTORY) != 0;
  if ((writes || folder) && fd >= 0 && fd < kMostFiles) {
    path_of[fd] = strdup(path);
    is_folder[fd] = (char)folder;
    if (writes) note("open", path, NULL);
  }
  return fd;
}

API ssize_t write(int fd, const void* bytes, size_t count) {
  if (pathOf(fd) == NULL) return syscall(SYS_write, fd, bytes, count);
  size_t fits = room >= 0 && (size_t)room < count ? (size_t)room : count;
  if (fails()) {
    if (fault > 0) return -1;
    if (fault == kKill) return syscall(SYS_write, fd, bytes, count / 2), killed();
    fits = (fits + 2) / 3;
  }
  if (fits == 0 && count > 0) {
    errno = ENOSPC;
    return -1;
  }
  const ssize_t done = syscall(SYS_write, fd, bytes, fits);
  if (done > 0 && room >= 0) room -= done;
  if (done >= 0) note("write", pathOf(fd), NULL);
  return done;
}

API int fsync(int fd) {
  if (pathOf(fd) != NULL && refused(1)) return -1;
  const int result = (int)syscall(SYS_fsync, fd);
  if (result == 0 && pathOf(fd) != NULL) note("fsync", pathOf(fd), NULL);
  return result;
}

API int close(int fd) {
  char* path = (char*)pathOf(fd);
  if (path == NULL) return (int)syscall(SYS_close, fd);
  const int bad = !is_folder[fd] && refused(1);
  const int error = errno;
  const int result = (int)syscall(SYS_close, fd);
  path_of[fd] = NULL;
  if (!bad && result == 0 && !is_folder[fd]) note("close", path, NULL);
  free(path);
  if (!bad) return result;
  errno = error;
  return -1;
}

API int fcntl(int fd, int command, ...) {
  va_list arguments;
  va_start(arguments, command);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  if (getenv("WELKIN_DISK_NO_LOCKS") != NULL &&
      (command == F_OFD_SETLK || command == F_OFD_SETLKW || command == F_OFD_GETLK)) {
    errno = ENOLCK;
    return -1;
  }
  return (int)syscall(SYS_fcntl, fd, command, argument);
}

API int rename(const char* from, const char* to) {
  if (refused(0)) return -1;
  const int result = (int)syscall(SYS_rename, from, to);
  if (result == 0) note("rename", from, to);
  return result;
}

API int mkdir(const char* path, mode_t mode) {
  if (refused(0)) return -1;
  const int result = (int)syscall(SYS_mkdir, path, mode);
  if (result == 0) note("mkdir", path, NULL);
  return result;
}

static int removeFile(const char* path, int flags) {
  if ((fault == kKill || stays) && refused(0)) return -1;
  const int result = (int)syscall(SYS_unlinkat, AT_FDCWD, path, flags);
  if (result == 0) note("unlink", path, NULL);
  return result;
}

API int unlink(const char* path) {
  return removeFile(path, 0);
}

API int remove(const char* path) {
  struct stat status;
  return removeFile(path, lstat(path, &status) == 0 && S_ISDIR(status.st_mode) ? AT_REMOVEDIR : 0);
}
