// SPDX-License-Identifier: Apache-2.0
// Ambient light of the sky from its spherical harmonics. `normal` is unit, in world axes.
// Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001.
// Needs: #extension GL_GOOGLE_include_directive : require, WELKIN_SET, WELKIN_BINDING_CONSTANTS.
#ifndef WELKIN_AMBIENT_GLSL
#define WELKIN_AMBIENT_GLSL

#include "constants.glsl"
#include "formulas.glsl"

// Bands to evaluate, 1 to 5. The default fits every bake, since missing coefficients are 0. A game that knows its bake
// may define fewer before it includes this file.
#ifndef WELKIN_BANDS
#define WELKIN_BANDS 5
#endif

// The share of one band in the irradiance.
vec3 welkinIrradianceOfBand(ShBasis basis, int band) {
  vec3 sum = vec3(0.0);
  for (int i = band * band; i < (band + 1) * (band + 1); ++i) sum += welkinSky.ambient_sh[i].rgb * basis.v[i];
  return cosineLobe(band) * sum;
}

// Irradiance E, pi included, clamped at 0: a truncated series can dip below it. Bands are written out, so that every
// loop has constant bounds and any compiler unrolls it.
vec3 welkinIrradiance(vec3 normal) {
  ShBasis basis = shBasis(normal);
  vec3 sum = welkinIrradianceOfBand(basis, 0);
#if WELKIN_BANDS > 1
  sum += welkinIrradianceOfBand(basis, 1);
#endif
#if WELKIN_BANDS > 2
  sum += welkinIrradianceOfBand(basis, 2);
#endif
#if WELKIN_BANDS > 3
  sum += welkinIrradianceOfBand(basis, 3);
#endif
#if WELKIN_BANDS > 4
  sum += welkinIrradianceOfBand(basis, 4);
#endif
  return max(sum, vec3(0.0));
}

// E / pi. Multiplied by an albedo it is the radiance of a diffuse surface.
vec3 welkinIrradianceOverPi(vec3 normal) { return welkinIrradiance(normal) / kPi; }

// The single-colour ambient light that spherical harmonics replaced in Far Cry 3 (McAuley 2012, figures 10 and 12): the
// irradiance, pi included, averaged over all normals.
vec3 welkinFlatIrradiance() {
  return max(cosineLobe(0) * welkinSky.ambient_sh[0].rgb * shBasis(vec3(0.0)).v[0], vec3(0.0));
}

vec3 welkinFlatIrradianceOverPi() { return welkinFlatIrradiance() / kPi; }

#endif
