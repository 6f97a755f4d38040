/* SPDX-License-Identifier: Apache-2.0
 *
 * A disk that runs full, for LD_PRELOAD: after WELKIN_DISK_BYTES bytes of write() to regular files, write() fails with
 * ENOSPC, the last one before it having written what fitted. */
#define _GNU_SOURCE
#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

static long left = -1;

__attribute__((visibility("default"))) ssize_t write(int fd, const void* bytes, size_t count) {
  struct stat status;
  if (fstat(fd, &status) != 0 || !S_ISREG(status.st_mode)) return syscall(SYS_write, fd, bytes, count);
  if (left < 0) {
    const char* text = getenv("WELKIN_DISK_BYTES");
    left = text != NULL ? atol(text) : 0;
  }
  if (left == 0 && count > 0) {
    errno = ENOSPC;
    return -1;
  }
  const ssize_t done = syscall(SYS_write, fd, bytes, count < (size_t)left ? count : (size_t)left);
  if (done > 0) left -= done;
  return done;
}
