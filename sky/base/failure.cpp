// SPDX-License-Identifier: Apache-2.0
#include "sky/base/failure.h"

#include <cerrno>
#include <cstring>
#include <new>
#include <string>
#include <system_error>

namespace welkin::base {

Error errorOf(const std::exception& exception) {
  if (const auto* error = dynamic_cast<const Error*>(&exception)) return *error;
  if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr) return {ExitStatus::file, "out of memory"};
  const std::string what = exception.what();
  if (dynamic_cast<const std::system_error*>(&exception) != nullptr) return {ExitStatus::file, what};
  // oneTBB reports a thread that it cannot make as a std::runtime_error with the system's words.
  for (const int refused : {EAGAIN, ENOMEM})
    if (what.find(std::strerror(refused)) != std::string::npos)
      return {ExitStatus::file, "the system refuses a thread or memory: " + what};
  return {ExitStatus::internal, "internal error: " + what};
}

}  // namespace welkin::base
