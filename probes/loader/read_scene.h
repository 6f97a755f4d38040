// SPDX-License-Identifier: Apache-2.0
// Reads a level's geometry, file by file.
#pragma once

#include "probes/level/scene.h"

namespace welkin::loader {

/// Reads every geometry of a level; a file that several entries name is read once. The result has at least one draw.
/// Images are read but not decoded. Throws Error as levelFileOf does, naming the file and the part of it.
level::Scene readScene(const level::LevelFile& level);

}  // namespace welkin::loader
