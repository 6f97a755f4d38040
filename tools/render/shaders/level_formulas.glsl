// SPDX-License-Identifier: Apache-2.0
// Formulas of the level picture that its tests need as well. They are pure functions, compiled as GLSL and, through
// level_formulas.h, as C++.

// Reflectance of water at normal incidence: ((n - 1) / (n + 1))^2 with n = 1.33.
CONSTANT Number kWaterReflectance = NUMBER(0.02);

// Extinction of clear tropical sea water, per metre, near 610, 550 and 450 nm: absorption of Pope and Fry, "Absorption
// spectrum (380-700 nm) of pure water", Applied Optics 36(33), 1997, with a little scattering added.
CONSTANT Number3 kWaterExtinction = Number3(NUMBER(0.30), NUMBER(0.075), NUMBER(0.045));

// Irradiance reflectance of water without a bottom in the same bands: clear blue water of Morel and Prieur, "Analysis of
// variations in ocean color", Limnology and Oceanography 22(4), 1977.
CONSTANT Number3 kWaterAlbedo = Number3(NUMBER(0.004), NUMBER(0.022), NUMBER(0.055));

// Fresnel reflectance for the cosine of the angle of incidence, in [0, 1]. Schlick, "An Inexpensive BRDF Model for
// Physically-based Rendering", Computer Graphics Forum 13(3), 1994, eq. 24.
INLINE Number schlick(Number at_normal, Number cosine) {
  Number m = NUMBER(1.0) - cosine;
  Number m2 = m * m;
  return at_normal + (NUMBER(1.0) - at_normal) * (m2 * m2 * m);
}

// Share of the light that remains after `path_m` through a medium of `extinction` per metre (Beer and Lambert).
INLINE Number transmittance(Number extinction, Number path_m) { return exp(-extinction * path_m); }

// Density of wave slopes (dy/dx, dy/dz): the share of the facets per unit of slope area. Each slope is normally
// distributed with `variance`. Cox and Munk, "Measurement of the Roughness of the Sea Surface from Photographs of the
// Sun's Glitter", JOSA 44(11), 1954, without their skewness.
INLINE Number slopeDensity(Number slope_x, Number slope_z, Number variance) {
  return exp(NUMBER(-0.5) * (slope_x * slope_x + slope_z * slope_z) / variance) / (kTwoPi * variance);
}

// Radiance of the sun's glitter for a normal irradiance of 1 and a reflectance of 1. `density` is taken at the slope of
// the half vector. p / (4 cos(view) cos^4(half)), with cosines to the vertical. Bruneton, Neyret and Holzschuch,
// "Real-time Realistic Ocean Lighting using Seamless Transitions from Geometry to BRDF", Eurographics 2010, eq. 7,
// without shadowing.
INLINE Number glitter(Number density, Number cos_view, Number cos_half) {
  Number c2 = cos_half * cos_half;
  return density / (NUMBER(4.0) * max(cos_view, NUMBER(0.05)) * c2 * c2);
}
