// SPDX-License-Identifier: Apache-2.0
// Soft parts of rooms' faces, for C++ and GLSL: how much light a place near a door has from the other side of its face.
// It is a fraction of membership that goes smoothly through the door, as the blurred mask of rooms in Stefanov, "Deferred
// Radiance Transfer Volumes" (GDC 2012). Files that need these formulas include this one beside formulas.glsl.

// A step from 0 to 1 over t in [0, 1] without bends at its ends.
INLINE Number doorStep(Number t) {
  Number in_range = clamp(t, NUMBER(0.0), NUMBER(1.0));
  return in_range * in_range * (NUMBER(3.0) - NUMBER(2.0) * in_range);
}

// Share of the light of the other side of a face, in [0, 1]. `p` runs along the face's normal, as do the face, and the
// ends of the door in the room and outside. Both sides give the same light at the face.
INLINE Number doorThrough(Number p, Number face, Number inner, Number outer) {
  Number from_outside = doorStep((p - inner) / (outer - inner));
  return (p - face) * (outer - inner) > NUMBER(0.0) ? NUMBER(1.0) - from_outside : from_outside;
}

// Fades a door out over `width` towards its sides at `low` and `high`.
INLINE Number doorFade(Number p, Number low, Number high, Number width) {
  return doorStep(min(p - low, high - p) / width);
}
