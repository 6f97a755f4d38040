// SPDX-License-Identifier: Apache-2.0
// Linked into programs that read images. OpenImageIO's PNG reader leaks a string when libpng jumps out of a damaged
// file.
extern "C" const char* __asan_default_options();

extern "C" __attribute__((visibility("default"))) const char* __asan_default_options() {
  return "detect_leaks=0";
}
