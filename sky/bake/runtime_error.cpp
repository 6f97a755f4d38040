// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/runtime_error.h"

#include <fmt/format.h>

#include "sky/base/error.h"

namespace welkin::bake {

void require(WelkinResult result, const std::string& path, const char* message) {
  if (result == WELKIN_OK) return;
  const char* reason = *message != '\0' ? message : welkin_result_string(result);
  const std::string text = path.empty() ? std::string(reason) : fmt::format("{}: {}", path, reason);
  switch (result) {
    case WELKIN_ERROR_FILE:
    case WELKIN_ERROR_MEMORY:
    case WELKIN_ERROR_DEVICE:
      throw base::Error(base::ExitStatus::file, text);
    case WELKIN_ERROR_FOREIGN:
    case WELKIN_ERROR_VERSION:
    case WELKIN_ERROR_TRUNCATED:
    case WELKIN_ERROR_CHECKSUM:
    case WELKIN_ERROR_CONTENT:
    case WELKIN_ERROR_KIND:
      throw base::Error(base::ExitStatus::content, text);
    default:
      throw base::Error(base::ExitStatus::internal, text);
  }
}

}  // namespace welkin::bake
