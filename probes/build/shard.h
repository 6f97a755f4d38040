// SPDX-License-Identifier: Apache-2.0
// --shard and --sectors: which sectors a bake is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "probes/geometry/sector.h"

namespace welkin::build {

/// Part `index` of `count` of a level: every count-th sector. 0 <= index < count.
struct Shard {
  int index = 0;
  int count = 1;
};

/// "i/n". Throws Error(usage) for anything else.
Shard parseShard(const std::string& text);

/// "X_Z,X_Z,...", ascending. Throws Error(usage) for anything else, and for one that is not of `level`.
std::vector<geometry::SectorId> parseSectors(const std::string& text, const std::vector<geometry::SectorId>& level);

}  // namespace welkin::build
