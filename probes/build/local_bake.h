// SPDX-License-Identifier: Apache-2.0
// The local transfer of a sector's bake: whether it gets any, of which virtual lights, and what fits its file.
#pragma once

#include <optional>

#include "probes/build/sector_bake.h"
#include "probes/sector.h"
#include "probes/tracer.h"

namespace welkin::probes {

/// LocalSettings::nearest_m. Each virtual light stands for lamps some metres about it, so one beside a wall must not
/// light the spot behind it as a lamp there would: every lamp that shares it would make that spot (local_bench has the
/// errors with and without).
inline constexpr double kNearest_m = 2.0;

/// Whether a sector gets local transfer. `transfer`: as sectionOf gives it; `near`: what lies within its reach.
bool hasLocalTransfer(const TransferSection& transfer, const Surfaces& near);

/// Virtual lights of a sector: its probes and those of the eight sectors about it, as far as they lie within reach, in
/// the order of sectors and, within one, of placement. Neighbours are placed again, out of what lies within reach of
/// this sector, for a sector's bytes depend on that alone: no file of theirs is read. Their own bakes see farther, so
/// near the end of the reach a virtual light may stand where the neighbour has no such probe. Nothing needs them to
/// agree: a sector's file has the places of its lights.
std::vector<Number3> virtualLights(const Tracer& tracer, const PlacedSector& sector, const BakeSection& section);

/// The local transfer of a sector that has probes, thinned to kMostLocalBytes. None when told to end. On all threads of
/// the caller's arena; the same for any number of them.
std::optional<BakedLocal> bakeLocal(const Tracer& tracer, const PlacedSector& sector, const SectorSettings& settings,
                                    const BakeProgress& progress);

}  // namespace welkin::probes
