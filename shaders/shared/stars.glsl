// SPDX-License-Identifier: Apache-2.0
// Where a direction falls on the star map, and how the sky's brightness fades it.
// The map is equirectangular in equatorial coordinates: rows from the celestial north pole; the middle column crosses the
// meridian at midnight, columns to its right have crossed it before (west, as one sees it looking south).

// Coordinates in [0, 1] of the map, z unused, at `turn_rad`, the angle by which the day has turned since midnight.
INLINE Number3 starCoordinates(Number3 direction, Number latitude_rad, Number north_offset_rad, Number turn_rad) {
  Number3 e = equatorialOf(direction, latitude_rad, north_offset_rad);
  Number u = (atan(e.z, e.x) - turn_rad) / kTwoPi + NUMBER(0.5);
  Number v = NUMBER(0.5) - atan(e.y, sqrt(e.x * e.x + e.z * e.z)) / kPi;
  return Number3(u - floor(u), v, NUMBER(0.0));
}

// Share of a star that is seen before a sky of luminance `sky`: 1 before black, 0 from the radiance of the map's white
// on, which `intensity` > 0 is. Smooth between.
INLINE Number starFade(Number sky, Number intensity) {
  Number t = clamp(sky / intensity, NUMBER(0.0), NUMBER(1.0));
  return NUMBER(1.0) - t * t * (NUMBER(3.0) - NUMBER(2.0) * t);
}
