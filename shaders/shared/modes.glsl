// SPDX-License-Identifier: Apache-2.0
// The map of the irradiance's modes. Opposite normals differ by the vector irradiance V, E(n) - E(-n) = n . V, so it holds
// the upper ones. The modes are symmetric about the sun's vertical plane: functions of the elevation and of the cosine of
// the azimuth from the sun's, in which an even function of the azimuth is smooth. Rows are even in 1 - sqrt(1 - y), which
// grows as the angle from the zenith does near it: a conical tip there, as a bright horizon makes one, is straight.

// Coordinate in [0, 1] of a unit normal by |y| and the length of its horizontal part, which gives sqrt(1 - |y|) without
// cancellation near the zenith.
INLINE Number modeRow(Number horizontal, Number abs_y) { return NUMBER(1.0) - horizontal / sqrt(NUMBER(1.0) + abs_y); }

// The y at a row's coordinate in [0, 1]: what modeRow inverts.
INLINE Number yOfModeRow(Number row) { return row * (NUMBER(2.0) - row); }

// Coordinate in [0, 1] of the azimuth of a unit normal, whose horizontal part is compared with the unit horizontal
// direction (x, z) towards the sun's azimuth. Any value at the zenith, where all columns are the same.
INLINE Number modeColumn(Number3 normal, Number horizontal, Number x, Number z) {
  Number cosine = (normal.x * x + normal.z * z) / max(horizontal, NUMBER(1e-6));
  return clamp(NUMBER(0.5) + NUMBER(0.5) * cosine, NUMBER(0.0), NUMBER(1.0));
}

// Irradiance, pi included, of a unit normal from a ground of radiance 1 under a black sky.
INLINE Number groundIrradiance(Number normal_y) { return kHalfPi * (NUMBER(1.0) - normal_y); }

// n . V of a unit normal from the radiance coefficients of y, z and x: the irradiance by which it exceeds its opposite.
INLINE Number3 excessIrradiance(Number3 normal, Number3 sh_y, Number3 sh_z, Number3 sh_x) {
  return (sh_y * normal.y + sh_z * normal.z + sh_x * normal.x) / kShLinear;
}
