// SPDX-License-Identifier: Apache-2.0
// Tells whether two files hold the same modes, so that weights of one can be added to weights of the other.
#pragma once

#include <cstdint>

#include "welkin_generated.h"

namespace welkin::format {

/// Hash of all that the modes are: sizes, texels and coefficients. Never 0. Skies that were baked as a family have the
/// same bytes there, and so the same hash.
std::uint64_t familyOf(const Modes& modes);

}  // namespace welkin::format
