// SPDX-License-Identifier: Apache-2.0
// A .welkin file of any kind.
#pragma once

#include <string>
#include <welkin/welkin.hpp>

#include "format/container.h"

namespace welkin::baked {

/// The kind that a file's header names. It is sky for a foreign file too; opening it as a sky then gives the reason.
format::Kind kindOfFile(const std::string& path);

/// The path itself, or PATH/sky.welkin if it is a folder. Throws Error(file) if a folder has no sky.welkin.
std::string skyFileOf(const std::string& path);

/// Opens a baked sky. Throws Error.
Sky openSky(const std::string& path);

}  // namespace welkin::baked
