// SPDX-License-Identifier: Apache-2.0
// Reads a level's geometry, file by file.
#pragma once

#include "probes/level/scene.h"

namespace welkin::loader {

/// Reads every geometry of a level, a file that several name once; at least one draw comes of it. Images are read and
/// not decoded. Throws Error as readLevelFile does, naming the file and the part of it.
level::Scene readScene(const level::LevelFile& level);

}  // namespace welkin::loader
