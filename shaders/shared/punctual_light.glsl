// SPDX-License-Identifier: Apache-2.0
// Point, spot and directional lights of glTF's KHR_lights_punctual (Khronos, 2019), for C++ and GLSL. Files that need
// them include this one beside formulas.glsl.

// Share of a light's intensity that its range leaves at a distance: max(1 - (d / range)^4, 0), from the distance's
// square in m2 and 1 / range^4. The latter is 0 for a light without a range.
INLINE Number rangeShare(Number squared_m2, Number inverse_range4) {
  return max(NUMBER(1.0) - squared_m2 * squared_m2 * inverse_range4, NUMBER(0.0));
}

// Share of a spot light's intensity at an angle off its axis, by the cosine of that angle. Scale and offset turn the
// cosine into 1 on the inner cone and 0 on the outer one; 0 and 1 make a light that shines everywhere.
INLINE Number coneShare(Number cosine, Number scale, Number offset) {
  Number inside = clamp(cosine * scale + offset, NUMBER(0.0), NUMBER(1.0));
  return inside * inside;
}
