// SPDX-License-Identifier: Apache-2.0
// The lobe that a rough surface reflects, seen along its normal: n = v = r. For the angle t between the light and the
// axis r, n.h = cos(t/2) and n.l = cos t, so Blinn-Phong's distribution times n.l is
//   w(t) = ((1 + cos t)/2)^(m/2) max(cos t, 0).
// The weight n.l is that of Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013 course notes, section "Image-Based
// Lighting". m is the power of shaders/shared/gloss.glsl, in [1, 8192].
#pragma once

#include "sh/deterministic_materials.h"

namespace welkin::reflection {

/// Gloss of a mip of a chain of `mips` >= 2: 1 - mip/(mips - 1), so the largest mip has gloss 1 and the last one 0.
double glossOfMip(int mip, int mips);

/// Number of mips of a cube of `size` >= 1 texels down to one texel: floor(log2 size) + 1.
int mipsOfSize(int size);

/// Weight w of light at an angle of cosine `cosine`, in [-1, 1]: 1 on the axis, 0 at 90 degrees and past them.
double lobeWeight(double power, double cosine);

/// Integral of w over the sphere, sr. In closed form, with p = m/2:
///   4 pi (2 (1 - 2^-(p+2))/(p + 2) - (1 - 2^-(p+1))/(p + 1)).
double lobeIntegral(double power);

/// The weight and its derivatives by the cosine, in (0, 1].
struct LobeSlopes {
  double value, first, second;
};
LobeSlopes lobeSlopes(double power, double cosine);

/// Width of the lobe's core, rad: near the axis w is about exp(-t^2 / (2 width^2)), of width 2/sqrt(m).
double lobeWidth(double power);

/// Least cosine at which ((1 + cos t)/2)^(m/2) is `share` in (0, 1), held to at least 0.
double lobeReach(double power, double share);

}  // namespace welkin::reflection
