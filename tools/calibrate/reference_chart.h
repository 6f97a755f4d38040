// SPDX-License-Identifier: Apache-2.0
// The wanted colours of the ColorChecker Classic's 24 patches, from dark skin row by row to black.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>

#include "calibrate/colour_space.h"

namespace welkin::calibrate {

inline constexpr std::size_t kColumns = 6, kRows = 4, kPatches = kColumns * kRows;

/// Linear Rec. 709 of every patch under D65, which is its diffuse albedo. Cyan lies outside Rec. 709: its red is below
/// 0.
using ReferenceChart = std::array<Colour, kPatches>;

/// X-Rite changed the pigments in November 2014. All charts by Calibrite are of the later edition.
enum class Edition { before_2014, after_2014 };

const char* patchName(std::size_t patch);

/// The maker's CIE L*a*b* under D50 for the 2 degree observer, as X-Rite, "New color specifications for ColorChecker SG
/// and Classic Charts" (2016) prints both editions.
ReferenceChart referenceChart(Edition edition);

/// Reads a measured chart: 24 lines of a name, L*, a* and b* under D50, with blanks between them. Lines that are empty
/// or start with # do not count. Throws Error(file), and Error(content) naming file and line.
ReferenceChart readReferenceChart(const std::filesystem::path& path);

}  // namespace welkin::calibrate
