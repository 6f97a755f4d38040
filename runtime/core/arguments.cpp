// SPDX-License-Identifier: Apache-2.0
#include "core/arguments.h"

#include <welkin/welkin.h>

#include <cstdarg>
#include <cstdio>

namespace welkin::core {
namespace {

thread_local char argument_error[192];

}  // namespace

WelkinResult fail(WelkinMessage* message, WelkinResult code, const char* format, ...) {
  if (message != nullptr) {
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(message->text, sizeof message->text, format, arguments);
    va_end(arguments);
  }
  return code;
}

WelkinResult refuse(const char* function, const char* format, ...) {
  const int length = std::snprintf(argument_error, sizeof argument_error, "%s: ", function);
  if (length > 0 && static_cast<std::size_t>(length) < sizeof argument_error) {
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(argument_error + length, sizeof argument_error - static_cast<std::size_t>(length), format,
                   arguments);
    va_end(arguments);
  }
  return WELKIN_ERROR_ARGUMENT;
}

}  // namespace welkin::core

const char* welkin_argument_error(void) {
  return welkin::core::argument_error;
}
