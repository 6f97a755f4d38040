// SPDX-License-Identifier: Apache-2.0
// A .welkin file of any kind.
#pragma once

#include <string>
#include <welkin/welkin.hpp>

namespace welkin::command {

enum class Holds { sky, sector, level };

/// What a file holds; a sky where that cannot be told, whose opening says why.
Holds whatHolds(const std::string& path);

/// Throws Error.
Sky openSky(const std::string& path);

}  // namespace welkin::command
