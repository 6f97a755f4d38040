// SPDX-License-Identifier: Apache-2.0
// Contact factors of `welkin contact`: a byte a vertex, by which a game multiplies the probes' light of a surface. They
// hold what lies between probes. Kavan, Bargteil and Sloan, "Least Squares Vertex Baking" (EGSR 2011).
#ifndef WELKIN_CONTACT_GLSL
#define WELKIN_CONTACT_GLSL

// The factor, in [0, 1.5], of a vertex attribute of one byte, VK_FORMAT_R8_UNORM in [0, 1]. Interpolate it over
// the triangle, and multiply welkinVolumeIrradiance of the front by it; of a back take 1.
float welkinContactFactor(float unorm) { return 1.5 * unorm; }

#endif
