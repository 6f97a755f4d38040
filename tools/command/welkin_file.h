// SPDX-License-Identifier: Apache-2.0
// A .welkin file of any kind.
#pragma once

#include <string>
#include <welkin/welkin.hpp>

#include "format/container.h"

namespace welkin::command {

/// The kind that a file's header names. It is sky for a foreign file too; opening it as a sky then gives the reason.
format::Kind kindOfFile(const std::string& path);

/// Opens a baked sky. Throws Error.
Sky openSky(const std::string& path);

}  // namespace welkin::command
