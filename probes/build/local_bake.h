// SPDX-License-Identifier: Apache-2.0
// The local transfer of a sector's bake: whether it gets any, of which virtual lights, and what fits its file.
#pragma once

#include "probes/build/sector_bake.h"
#include "probes/geometry/sector.h"
#include "probes/geometry/tracer.h"
#include "probes/transfer/trace_transfer.h"
#include "sky/base/progress.h"

namespace welkin::build {

using f64::Number3;

/// LocalSettings::nearest_m. Each virtual light stands for lamps some metres about it, so one beside a wall must not
/// light the spot behind it as a lamp there would: every lamp that shares it would make that spot (local_bench has the
/// errors with and without).
inline constexpr double kNearest_m = 2.0;

/// Whether a sector gets local transfer. Of the level's surfaces only lights within the sector's reach count.
bool hasLocalTransfer(geometry::SectorId sector, const TransferSection& transfer, const geometry::Surfaces& level);

/// Virtual lights of a sector: its probes and those of the eight sectors about it, as far as they lie within reach, in
/// the order of sectors and, within one, of placement. Neighbours are placed again, each out of the surfaces that its
/// own bake reads: no file of theirs is read, and the lights are their probes. Positions are of the caller's world,
/// where a bake has its sector as 0_0. `near`, `section`: as columnOfBake reaches; what the progress throws ends it.
std::vector<Number3> virtualLights(const geometry::Surfaces& near, const geometry::PlacedSector& sector,
                                   const BakeSection& section, const base::Progress& progress = {});

/// The local transfer of a sector that has probes, thinned to kMostLocalBytes. On all threads of the caller's arena;
/// the same for any number of them. `tracer`: of what the sector's probes see; what `progress` throws ends the bake.
sectors::BakedLocal bakeLocal(const geometry::Tracer& tracer, const geometry::Surfaces& near,
                              const geometry::PlacedSector& sector, const SectorSettings& settings,
                              const base::Progress& progress);

}  // namespace welkin::build
