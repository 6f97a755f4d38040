// SPDX-License-Identifier: Apache-2.0
// The jetty, the fishing boats and the driftwood.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

/// A jetty of 30 m that runs to -z from the beach at the origin; sea level is y = 0.
Mesh jetty();

/// A bleached trunk of 4 m with two stubs, along x, half sunk in the sand.
Mesh driftwood();

/// An open boat of 5.6 m, bow to -z, afloat at y = 0. Its upper strake has the material "boat_red".
Mesh boat();

}  // namespace welkin::island
