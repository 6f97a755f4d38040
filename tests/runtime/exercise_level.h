// SPDX-License-Identifier: Apache-2.0
// Opens the bytes of a sector or of a level's index through the runtime, and uses all that it accepts.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace welkin::tests {

/// Outcome of one file.
struct LevelExercise {
  bool opened = false;  ///< the runtime accepted the file
  std::string fault;    ///< rule of the interface that was broken; empty if none was
};

/// Exercises a file. The other files match it: an index names the checksum of a sector, and the entries of an index get
/// the checksums of the sectors of a random level. A sector has a copy of itself as its neighbour, so that look-ups
/// cross their border.
LevelExercise exerciseFile(std::span<const std::byte> file);

}  // namespace welkin::tests
