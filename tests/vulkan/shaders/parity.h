// SPDX-License-Identifier: Apache-2.0
// One list of calls of the shared formulas, compiled as C++ and as GLSL. put(scalar) and put3(vector) store the
// results.
#ifndef WELKIN_PARITY_H
#define WELKIN_PARITY_H

#define WELKIN_PARITY_COUNT 73

#define WELKIN_PARITY_BODY                                                                                \
  LuminanceModel clear_sky =                                                                              \
      LuminanceModel(NUMBER(-1.0), NUMBER(-0.32), NUMBER(10.0), NUMBER(-3.0), NUMBER(0.45), NUMBER(0.0)); \
  LuminanceModel overcast =                                                                               \
      LuminanceModel(NUMBER(4.0), NUMBER(-0.7), NUMBER(2.0), NUMBER(-1.5), NUMBER(0.15), NUMBER(2.0));    \
  put(gradation(clear_sky, a.y));                                                                         \
  put(gradation(overcast, a.y));                                                                          \
  put(gradation(clear_sky, NUMBER(0.0)));                                                                 \
  put(indicatrix(clear_sky, angleBetween(a, b)));                                                         \
  put(indicatrix(overcast, angleBetween(a, b)));                                                          \
  put(angleBetween(a, b));                                                                                \
  put(angleBetween(a, a));                                                                                \
  put(angleBetween(a, -a));                                                                               \
  put(luminanceNorm(clear_sky, b, true));                                                                 \
  put(luminanceNorm(clear_sky, b, false));                                                                \
  put(relativeLuminance(clear_sky, a, b, NUMBER(1.5)));                                                   \
  put(luminanceOf(rgb));                                                                                  \
  put3(chromaticity(rgb, NUMBER(0.2)));                                                                   \
  put3(desaturate(rgb, NUMBER(0.3)));                                                                     \
  put(azimuthWeight(a, b));                                                                               \
  put(gradientRow(angle_rad, NUMBER(7.0)));                                                               \
  put(gradientColumn(time_h, NUMBER(5.0)));                                                               \
  put(horizontalLength(a));                                                                               \
  put(elevationOf(a));                                                                                    \
  put3(directionOf(NUMBER(2.0) * angle_rad, angle_rad));                                                  \
  put3(celestialDirection(time_h / NUMBER(12.0) * kPi - kPi, NUMBER(0.3), angle_rad, NUMBER(0.7)));       \
  put(expMinusOne(x));                                                                                    \
  put(expMinusOne(x* NUMBER(1e-3)));                                                                      \
  ShBasis basis = shBasis(a);                                                                             \
  for (int j = 0; j < 25; ++j) put(basis.v[j]);                                                           \
  for (int j = 0; j < 5; ++j) put(cosineLobe(j));                                                         \
  for (int j = 0; j < 5; ++j) put(groundLobe(j));                                                         \
  put(modeRow(horizontalLength(a), max(a.y, -a.y)));                                                      \
  put(yOfModeRow(rgb.x));                                                                                 \
  put(modeColumn(a, horizontalLength(a), sin(NUMBER(2.0) * angle_rad), cos(NUMBER(2.0) * angle_rad)));    \
  put(groundIrradiance(a.y));                                                                             \
  put3(excessIrradiance(a, rgb, b, rgb* x));

#endif
