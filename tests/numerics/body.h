// SPDX-License-Identifier: Apache-2.0
// The models for the formulas of formulas.h, and the calls. Needs a, b (unit directions), near_b (a direction close to
// b), rgb (Number3), azimuth_rad, angle_rad (an elevation), x (at most 0), up (the cosine of a zenith angle, above 0),
// theta (in [0, pi]) and s, t (in [0, 1]), as Number.
#ifndef WELKIN_NUMERICS_BODY_H
#define WELKIN_NUMERICS_BODY_H

#include "formulas.h"

// Numbers of floats in an evaluation's arguments, and of its results.
#define WELKIN_NUMERICS_ARGUMENTS 20
#define WELKIN_NUMERICS_RESULTS 165

#define WELKIN_NUMERICS_BODY                                                   \
  LuminanceModel clear_sky = WELKIN_MODEL(-1.0, -0.32, 10.0, -3.0, 0.45, 0.0); \
  LuminanceModel thin = WELKIN_MODEL(-1.0, -1e-4, 0.0, -1.0, 0.0, 0.0);        \
  LuminanceModel overcast = WELKIN_MODEL(4.0, -0.7, 2.0, -1.5, 0.15, 2.0);     \
  LuminanceModel strong = WELKIN_MODEL(1e4, -0.7, 1e4, -6.0, 0.15, 0.0);       \
  LuminanceModel delta = WELKIN_MODEL(0.0, -1.0, 1e4, -1e3, 0.0, 0.0);         \
  WELKIN_FORMULAS_OF_ANGLES                                                    \
  WELKIN_FORMULAS_OF_LUMINANCE                                                 \
  WELKIN_FORMULAS_OF_COLOUR                                                    \
  WELKIN_FORMULAS_OF_MATERIALS                                                 \
  ShBasis basis = shBasis(a);                                                  \
  for (int j = 0; j < 25; ++j) PUT(shBasis, 1.0, "a", basis.v[j])              \
  for (int j = 0; j < 5; ++j) PUT(cosineLobe, 0.0, "", cosineLobe(j))          \
  for (int j = 0; j < 5; ++j) PUT(groundLobe, 0.0, "", groundLobe(j))          \
  TransferBasis transfer = transferBasis();                                    \
  for (int j = 0; j < 4; ++j) PUT3(transferBasis, 1.0, "", transfer.v[j])      \
  TransferWeights weights = transferWeights(a);                                \
  for (int j = 0; j < 4; ++j) PUT(transferWeights, 1.0, "a", weights.v[j])

#endif
