// SPDX-License-Identifier: Apache-2.0
// Position of a direction on the star map, and the fading of stars by the sky's brightness. The map is equirectangular
// in equatorial coordinates, with rows from the celestial north pole. The middle column crosses the meridian at
// midnight. Columns to its right cross it earlier (west, as seen looking south).

// Coordinates in [0, 1] of the map, z unused. `turn_rad` is the angle by which the day has turned since midnight.
INLINE Number3 starCoordinates(Number3 direction, Number latitude_rad, Number north_offset_rad, Number turn_rad) {
  Number3 e = equatorialOf(direction, latitude_rad, north_offset_rad);
  Number u = (atan(e.z, e.x) - turn_rad) / kTwoPi + NUMBER(0.5);
  Number v = NUMBER(0.5) - atan(e.y, sqrt(e.x * e.x + e.z * e.z)) / kPi;
  return Number3(u - floor(u), v, NUMBER(0.0));
}

// Visible share of a star before a sky of luminance `sky`: 1 before black, 0 once the sky reaches `intensity` > 0, the
// radiance of the map's white. Smooth between.
INLINE Number starFade(Number sky, Number intensity) {
  Number t = clamp(sky / intensity, NUMBER(0.0), NUMBER(1.0));
  return NUMBER(1.0) - t * t * (NUMBER(3.0) - NUMBER(2.0) * t);
}
