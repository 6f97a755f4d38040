// SPDX-License-Identifier: Apache-2.0
// Fits the transfer of the sky. A probe's irradiance in direction b of the transfer basis, under a sky of coefficients
// c_k, is the sum over k of X_k c_k, with X_k = visibility A_k Y_k(b) + T_k and the cosine lobe's factors A_k. So what
// the sky's visibility cannot say goes to the transfer T of bounced light.
#pragma once

#include "probes/fit/least_squares.h"
#include "probes/fit/point_light.h"
#include "probes/transfer/transfer.h"

namespace welkin::fit {

/// Unknown b + kDirections i is direction b of probe i. `rows` and `light` belong to the same points. Visibility stays
/// within [0, 1], and the transfer of coefficients 0 and 1 not below 0, as the files store them.
void fitSky(const NormalMatrix& matrix, std::span<const Row> rows, std::span<const PointLight> light,
            const TrainingSkies& skies, std::span<transfer::ProbeTransfer* const> probes);

}  // namespace welkin::fit
