// SPDX-License-Identifier: Apache-2.0
// The runtime's refusals as Errors.
#pragma once

#include <welkin/welkin.h>

#include <string>

namespace welkin::bake {

/// Throws the Error that a failed runtime call stands for: "path: message", or the message alone for an empty path.
void require(WelkinResult result, const std::string& path, const char* message);

}  // namespace welkin::bake
