/* SPDX-License-Identifier: Apache-2.0
 *
 * A library for LD_PRELOAD that changes the floating-point environment, as libraries built for fast arithmetic do. It
 * sets the bits WELKIN_MXCSR (hexadecimal) of the SSE control register when it is loaded. If WELKIN_MXCSR_LATE is set,
 * it waits until the program loads the module that reads images. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <xmmintrin.h>

static void set(void) {
  const char* bits = getenv("WELKIN_MXCSR");
  if (bits != NULL) _mm_setcsr(_mm_getcsr() | (unsigned)strtoul(bits, NULL, 16));
}

static __attribute__((constructor)) void atLoad(void) {
  if (getenv("WELKIN_MXCSR_LATE") == NULL) set();
}

__attribute__((visibility("default"))) void* dlopen(const char* path, int flags) {
  void* (*next)(const char*, int) = NULL;
  *(void**)&next = dlsym(RTLD_NEXT, "dlopen");
  void* library = next(path, flags);
  if (path != NULL && strstr(path, "welkin_image") != NULL) set();
  return library;
}
