// SPDX-License-Identifier: Apache-2.0
// Relative luminance of the sky: CIE S 011/E:2003 / ISO 15469:2004 "CIE standard general sky", and the form of Far Cry 3
// (McAuley, "Calibrating Lighting and Materials in Far Cry 3", SIGGRAPH 2012 course notes), normalised to the sun.
// Errata of the notes: Table 1 prints c = -10 and -24 for +10 and +24, and the numerator closes the bracket of c too late.

// Gradation f(Z) = 1 + a exp(b / cos Z) + k cos Z and indicatrix g(theta) = 1 + c (exp(d theta) - exp(d pi/2)) +
// e cos^2 theta. k = 0 in the standard's fifteen types; a = 0, k = 2 is the traditional overcast sky (Moon and Spencer
// 1942). Domain: b < 0, d < 0, f > 0 and g > 0 wherever they are evaluated.
struct LuminanceModel {
  Number a;
  Number b;
  Number c;
  Number d;
  Number e;
  Number k;
};

// f at the cosine of the zenith angle. A cosine up to 1e-30 gives the limit at the horizon, 1, because b / cos Z would
// overflow. Both forms avoid cancellation.
// A negative a uses 1 + a exp(x) = (1 + a) + a expm1(x), because 1 and a would cancel at the zenith. A positive a uses
// the sum as it stands, because 1 + a and a would cancel at the horizon. One of the two has the factor 0.
INLINE Number gradation(LuminanceModel m, Number cos_zenith) {
  if (!(cos_zenith > NUMBER(1e-30))) return NUMBER(1.0);
  Number below = min(m.a, NUMBER(0.0));
  Number above = max(m.a, NUMBER(0.0));
  Number x = m.b / cos_zenith;
  return (NUMBER(1.0) + below) + SCALED(below, expMinusOne(x)) + SCALED(above, exp(x)) + m.k * cos_zenith;
}

// g from exp(d theta), exp(d pi/2) and the cosine of theta, the angle to the sun.
INLINE Number indicatrixFrom(LuminanceModel m, Number exponential, Number at_right_angle, Number cosine) {
  return NUMBER(1.0) + m.c * (exponential - at_right_angle) + m.e * cosine * cosine;
}

// g at the angle to the sun, radians in [0, pi].
INLINE Number indicatrix(LuminanceModel m, Number sun_angle_rad) {
  return indicatrixFrom(m, exp(m.d * sun_angle_rad), exp(m.d * kHalfPi), cos(sun_angle_rad));
}

// The constant factor of luminanceNorm over a day: g at the sun, or f at the zenith.
INLINE Number constantNorm(LuminanceModel m, bool normalise_to_sun) {
  return normalise_to_sun ? indicatrix(m, NUMBER(0.0)) : gradation(m, NUMBER(1.0));
}

// Computes luminanceNorm from constantNorm.
INLINE Number luminanceNormFrom(LuminanceModel m, Number3 sun, bool normalise_to_sun, Number constant) {
  if (normalise_to_sun) return constant * gradation(m, sun.y);
  return constant * indicatrix(m, angleBetween(sun, Number3(NUMBER(0.0), NUMBER(1.0), NUMBER(0.0))));
}

// Luminance of the normalising direction before normalisation: the sun (Far Cry 3) or the zenith (CIE). The sun may be
// below the horizon. Then the horizon's gradation and the sun's true angle are used.
INLINE Number luminanceNorm(LuminanceModel m, Number3 sun, bool normalise_to_sun) {
  return luminanceNormFrom(m, sun, normalise_to_sun, constantNorm(m, normalise_to_sun));
}

// Luminance of a direction relative to the normalising one. 0 below the horizon.
INLINE Number relativeLuminance(LuminanceModel m, Number3 direction, Number3 sun, Number norm) {
  if (direction.y < NUMBER(0.0)) return NUMBER(0.0);
  return gradation(m, direction.y) * indicatrix(m, angleBetween(direction, sun)) / norm;
}
