// SPDX-License-Identifier: Apache-2.0
// OpenImageIO's PNG reader leaks a string when libpng jumps out of a damaged file. Tests that read one ignore that
// leak, and no other.
extern "C" const char* __lsan_default_suppressions();

extern "C" __attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libOpenImageIO";
}
