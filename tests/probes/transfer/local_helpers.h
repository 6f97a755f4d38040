// SPDX-License-Identifier: Apache-2.0
// Helpers that the tests of local transfer share.
#pragma once

#include "probes/transfer/local_transfer.h"
#include "tests/probes/rooms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

/// The transfer of a light, or none.
inline transfer::LocalTransfer of(const transfer::LocalProbe& probe, std::uint32_t light) {
  for (const transfer::LocalTransfer& t : probe.transfer)
    if (t.light == light) return t;
  return {light, {}};
}

/// A room with a pillar, open to one side, walls of three colours.
inline geometry::Surfaces furnishedRoom() {
  geometry::Surfaces s;
  addBoxInside(s, {-5, 0, -4}, {5, 4, 4}, addMaterial(s, {0.7, 0.5, 0.3}));
  addBoxOutside(s, {0.5, 0, -1.5}, {1.2, 4, 1}, addMaterial(s, {0.2, 0.6, 0.8}));
  addQuad(s, {-5, 1, -4}, {0, 0, 8}, {2, 0, 0}, addMaterial(s, {0.9, 0.1, 0.4}, true));
  return s;
}

}  // namespace welkin::tests
