// SPDX-License-Identifier: Apache-2.0
// The demonstrations of Stefanov, "Deferred Radiance Transfer Volumes", GDC 2012, as small levels of 48 x 48 m.
#pragma once

#include <array>

#include "generate/scene.h"

namespace welkin::talk {

/// A level's folder and geometry, `name`/`name`.gltf.
struct TalkLevel {
  const char* name;
  island::GltfFiles files;
};

/// walls: a red wall in the west and a green one in the east, with white spheres between. yard: a white house with a
/// roof, and fences. lamp: a wall that hides a place from a lamp, and a wall that both see.
std::array<TalkLevel, 3> talkLevels();

}  // namespace welkin::talk
