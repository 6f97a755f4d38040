/* SPDX-License-Identifier: Apache-2.0
 * Guard bytes around the structs that programs of an earlier release hand to the library. */
#pragma once

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <welkin/welkin.h>

#define GUARDS 64
#define GUARDED(type)             \
  static struct {                 \
    unsigned char before[GUARDS]; \
    type value;                   \
    unsigned char after[GUARDS];  \
  }

static void fail(const char* what) {
  fprintf(stderr, "%s: %s\n", what, welkin_argument_error());
  exit(1);
}

static void guard(void* before, void* after) {
  memset(before, 0xa5, GUARDS);
  memset(after, 0xa5, GUARDS);
}

static void check(const char* what, const unsigned char* before, const unsigned char* after) {
  int i;
  for (i = 0; i < GUARDS; ++i)
    if (before[i] != 0xa5 || after[i] != 0xa5) fail(what);
}

#define CALL(variable, call)                       \
  do {                                             \
    guard(variable.before, variable.after);        \
    if ((call) != WELKIN_OK) fail(#call);          \
    check(#call, variable.before, variable.after); \
  } while (0)

static void floats(const char* name, const float* v, size_t count) {
  size_t i;
  printf("%s", name);
  for (i = 0; i < count; ++i) printf(" %a", (double)v[i]);
  printf("\n");
}
