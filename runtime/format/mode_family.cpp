// SPDX-License-Identifier: Apache-2.0
#include "format/mode_family.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>

namespace welkin::format {

std::uint64_t familyOf(const Modes& modes) {
  XXH3_state_t state;
  XXH3_64bits_reset(&state);
  const std::uint32_t size[3] = {modes.count(), modes.columns(), modes.rows()};
  XXH3_64bits_update(&state, size, sizeof size);
  XXH3_64bits_update(&state, modes.texels()->data(), modes.texels()->size() * sizeof(std::uint16_t));
  XXH3_64bits_update(&state, modes.polar_sh()->data(), modes.polar_sh()->size() * sizeof(float));
  return std::max<std::uint64_t>(XXH3_64bits_digest(&state), 1);
}

}  // namespace welkin::format
