// SPDX-License-Identifier: Apache-2.0
// A file of commands, one a line.
#pragma once

#include <string>

#include "view/session.h"

namespace welkin::view {

/// Performs all commands of a file in order. Throws Error(content) that begins with FILE:LINE.
void runScript(Session& session, const std::string& path);

}  // namespace welkin::view
