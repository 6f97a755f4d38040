// SPDX-License-Identifier: Apache-2.0
// Leaks are not looked for under AddressSanitizer: drivers leave some behind and are unloaded before the report, so
// that no suppression can name them. Leaked Vulkan objects are found by validation.
#if defined(__SANITIZE_ADDRESS__)
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options();
const char* __asan_default_options() {
  return "detect_leaks=0";
}
#endif
