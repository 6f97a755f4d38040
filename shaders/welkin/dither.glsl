// SPDX-License-Identifier: Apache-2.0
// Keeps skies from banding. Add welkinDither(pixel) / 255 to an encoded colour before it is rounded to 8 bits.
#ifndef WELKIN_DITHER_GLSL
#define WELKIN_DITHER_GLSL

#include "formulas.glsl"

vec3 welkinDither(ivec2 pixel) { return vec3(ditherAt(pixel.x, pixel.y)); }

#endif
