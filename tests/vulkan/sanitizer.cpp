// SPDX-License-Identifier: Apache-2.0
// Turns off AddressSanitizer's leak detection. Drivers leave leaks behind and are unloaded before the report, so no
// suppression can name them. Validation finds leaked Vulkan objects.
#if defined(__SANITIZE_ADDRESS__)
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options();
const char* __asan_default_options() {
  return "detect_leaks=0";
}
#endif
