// SPDX-License-Identifier: Apache-2.0
#include "sky/base/module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cfenv>

#include "sky/base/error.h"

namespace welkin::base {

void* loadModule(const char* file, const char* entry, const char* what) {
  std::fenv_t arithmetic;  // libraries built for fast arithmetic change it when they are loaded
  std::fegetenv(&arithmetic);
  void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  std::fesetenv(&arithmetic);
  if (library == nullptr) throw Error(ExitStatus::file, fmt::format("cannot load {}: {}", what, dlerror()));
  void* found = dlsym(library, entry);
  if (found == nullptr) throw Error(ExitStatus::file, fmt::format("{}: {}", file, dlerror()));
  return found;
}

}  // namespace welkin::base
