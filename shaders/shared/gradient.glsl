// SPDX-License-Identifier: Apache-2.0
// Position of a time and an elevation on a gradient image, and the blend of the two gradients over azimuth. Columns are
// centred on 24 (i + 1/2) / width hours and wrap. Rows, counted from the horizon, are centred on (j + 1/2) / height of
// pi/2 and clamp.

// Horizontal length, sin 10 degrees, below which the blend over azimuth fades, so that the zenith is continuous.
CONSTANT Number kAzimuthFade = NUMBER(0.17364817766693034885);

// Column coordinate of a time in hours, in [-1/2, width - 1/2]: the integer part is the column to the left.
INLINE Number gradientColumn(Number time_h, Number width) { return time_h / NUMBER(24.0) * width - NUMBER(0.5); }

// Row coordinate of an elevation in radians, clamped to [0, height - 1]; row 0 is at the horizon.
INLINE Number gradientRow(Number elevation_rad, Number height) {
  return clamp(elevation_rad / kHalfPi * height - NUMBER(0.5), NUMBER(0.0), height - NUMBER(1.0));
}

// Weight of the sun-side gradient, in [0, 1]: half of one plus the cosine of the azimuth between direction and sun. It
// is clamped, because rounding past the ends would make a pure primary's complement negative.
INLINE Number azimuthWeight(Number3 direction, Number3 sun) {
  Number cosine = direction.x * sun.x + direction.z * sun.z;
  Number lengths = max(horizontalLength(direction), kAzimuthFade) * max(horizontalLength(sun), kAzimuthFade);
  return clamp(NUMBER(0.5) + NUMBER(0.5) * cosine / lengths, NUMBER(0.0), NUMBER(1.0));
}
