// SPDX-License-Identifier: Apache-2.0
// A .welkin file of any kind.
#pragma once

#include <string>
#include <welkin/welkin.hpp>

namespace welkin::command {

enum class Holds { sky, sector, level };

/// The kind of a file's content. It is sky for unreadable content too; opening it as a sky then gives the reason.
Holds whatHolds(const std::string& path);

/// Opens a baked sky. Throws Error.
Sky openSky(const std::string& path);

}  // namespace welkin::command
