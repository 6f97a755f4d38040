// SPDX-License-Identifier: Apache-2.0
// What skies must have in common to be baked as a family, whose blends are as exact as each of them.
#pragma once

#include <span>

#include "sky/bake/sky_file.h"

namespace welkin::bake {

/// Throws Error(content), with both files, the key and its values, where two skies differ in luminance_unit, in the
/// sun's path, which their modes stand about, or in the settings that say how irradiance is held: max_error or none,
/// target, bands, reconstruction, window.
void checkFamily(std::span<const SkyFile> family);

/// The same for the skies of a level: its sectors hold one path of sun and moon and one ground_albedo.
void checkLevelFamily(std::span<const SkyFile> family);

/// Names each sky but the first `named` ones after its file, without suffix. Throws Error(content) where two would have
/// one name, or where the name is that of another output: level, report, timing.
void nameAfterFiles(std::span<SkyFile> family, std::size_t named = 0);

/// Tells every sky the inputs of the others, by which a record is out of date when one of them changes.
void relate(std::span<SkyFile> family);

}  // namespace welkin::bake
