// SPDX-License-Identifier: Apache-2.0
// The discs that the dome draws: a soft edge, the moon's phase, and the share of a disc above the horizon.

// Share of a pixel that a disc covers, in [0, 1]: 1 inside, 0 outside, linear over `pixel_rad` at its edge. A disc
// smaller than a pixel keeps about its energy. A disc of radius 0 covers nothing. Angles are in radians; `angle_rad` is
// the angle from the disc's centre.
INLINE Number discCoverage(Number angle_rad, Number radius_rad, Number pixel_rad) {
  Number pixel = max(pixel_rad, NUMBER(1e-6));
  Number coverage = clamp((radius_rad - angle_rad) / pixel + NUMBER(0.5), NUMBER(0.0), NUMBER(1.0));
  Number smaller = min(NUMBER(2.0) * radius_rad / pixel, NUMBER(1.0));
  return coverage * smaller * smaller;
}

// Brightness of the moon's disc in unit `direction`, relative to a full moon. The moon is a sphere lit by the sun. The
// terminator is softened as on a rough surface, and the night side has a little earthshine. A full moon is a flat disc.
INLINE Number moonPhase(Number3 direction, Number3 moon, Number radius_rad, Number3 sun) {
  Number3 offset = direction - moon;  // exact where they are close; direction - moon dot(direction, moon) cancels there
  Number3 across = (offset - moon * dot(offset, moon)) / sin(max(radius_rad, NUMBER(1e-4)));
  Number from_centre = min(dot(across, across), NUMBER(1.0));
  Number3 normal = across - moon * sqrt(NUMBER(1.0) - from_centre);
  Number lit = clamp(dot(normal, sun) * NUMBER(4.0) + NUMBER(0.2), NUMBER(0.0), NUMBER(1.0));
  return NUMBER(0.01) + NUMBER(0.99) * lit * lit * (NUMBER(3.0) - NUMBER(2.0) * lit);
}

// Threshold of an 8 x 8 ordered dither in (-1/2, 1/2), which keeps skies from banding. Add it in units of the last
// place after tone mapping and before rounding. Bayer (1973): the bits of x ^ y and y interleaved, the lowest first.
INLINE Number ditherAt(int x, int y) {
  int rank = 0;
  for (int bit = 0; bit < 3; ++bit) {
    int a = (x >> bit) & 1;
    int b = (y >> bit) & 1;
    rank = rank * 4 + (a ^ b) * 2 + b;
  }
  return (Number(rank) + NUMBER(0.5)) / NUMBER(64.0) - NUMBER(0.5);
}
