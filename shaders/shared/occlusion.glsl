// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion in slices of the hemisphere, for C++ and GLSL: Jimenez, Wu, Pesce and Jarabo, "Practical Realtime
// Strategies for Accurate Indirect Occlusion", 2016. A slice is the plane of the view direction and a tangent
// perpendicular to it. In it an angle h counts from the view direction towards the tangent, in [-pi, pi], radians. The
// angle gamma is that of the normal's projection into the slice, in (-pi/2, pi/2). Files that need these formulas
// include this one beside formulas.glsl.

// Integral of cos(h - gamma) |sin h| between 0 and h, >= 0 on either side; eq. 7 there. All slices meet in the view
// direction, so |sin h| is the width of a slice at h.
INLINE Number sliceArc(Number h, Number gamma) {
  return NUMBER(0.25) * (cos(gamma) - cos(NUMBER(2.0) * h - gamma) + NUMBER(2.0) * h * sin(gamma));
}

// Cosine-weighted light of a slice between two horizons, by the cosines of their angles from the view direction:
// `against` on the side away from the tangent, `along` on the tangent's. Each is in [-1, 1], and -1 is no horizon.
// Light from below the surface does not count, so an open slice has cos gamma + gamma sin gamma, in [1, pi/2).
INLINE Number sliceLight(Number against, Number along, Number gamma) {
  Number left = atan(sqrt(max(NUMBER(1.0) - against * against, NUMBER(0.0))), against);
  Number right = atan(sqrt(max(NUMBER(1.0) - along * along, NUMBER(0.0))), along);
  return sliceArc(max(-left, gamma - kHalfPi), gamma) + sliceArc(min(right, gamma + kHalfPi), gamma);
}

// Turn of a pixel's slices, in [0, 1): every sixteenth once in any 4 x 4 pixels.
INLINE Number sliceTurn(int x, int y) { return Number((((x + y) & 3) << 2) + (x & 3)) / NUMBER(16.0); }

// Offset of a pixel's steps, in (0, 1): each of four values four times in any 4 x 4 pixels.
INLINE Number stepOffset(int x, int y) { return (Number((y - x) & 3) + NUMBER(0.5)) / NUMBER(4.0); }
