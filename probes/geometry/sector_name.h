// SPDX-License-Identifier: Apache-2.0
// The name of a sector: X_Z, as in --sectors, in level.toml and in file names.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "probes/geometry/sector.h"

namespace welkin::geometry {

/// Sectors farther out than this on either axis are refused: a million metres.
inline constexpr int kFarthestSector = 15625;

/// "X_Z", such as "-1_12".
std::string nameOf(SectorId sector);

/// The sector with a name as nameOf writes it; nothing for any other text.
std::optional<SectorId> sectorOf(std::string_view name);

/// "sector_X_Z.welkin"
std::string fileNameOf(SectorId sector);

}  // namespace welkin::geometry
