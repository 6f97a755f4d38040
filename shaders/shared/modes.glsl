// SPDX-License-Identifier: Apache-2.0
// The map of the irradiance's modes. It holds the upper normals only: opposite normals differ by the vector irradiance
// V: E(n) - E(-n) = n . V. The modes are symmetric about the sun's vertical plane, so they are functions of the
// elevation and of the cosine of the azimuth from the sun's. An even function of the azimuth is smooth in that cosine.
// Rows are even in 1 - sqrt(1 - y), which near the zenith grows as the angle from it. A conical tip there, such as a
// bright horizon causes, becomes a straight line.

// Row coordinate in [0, 1] of a unit normal, from |y| and the length of its horizontal part. The length gives sqrt(1 -
// |y|) without cancellation near the zenith.
INLINE Number modeRow(Number horizontal, Number abs_y) { return NUMBER(1.0) - horizontal / sqrt(NUMBER(1.0) + abs_y); }

// The y at a row coordinate in [0, 1]: the inverse of modeRow.
INLINE Number yOfModeRow(Number row) { return row * (NUMBER(2.0) - row); }

// Column coordinate in [0, 1] of a unit normal's azimuth. (x, z) is the unit horizontal direction towards the sun's
// azimuth. At the zenith the value is arbitrary, because all columns are the same there.
INLINE Number modeColumn(Number3 normal, Number horizontal, Number x, Number z) {
  Number cosine = (normal.x * x + normal.z * z) / max(horizontal, NUMBER(1e-6));
  return clamp(NUMBER(0.5) + NUMBER(0.5) * cosine, NUMBER(0.0), NUMBER(1.0));
}

// Irradiance, pi included, of a unit normal from a ground of radiance 1 under a black sky.
INLINE Number groundIrradiance(Number normal_y) { return kHalfPi * (NUMBER(1.0) - normal_y); }

// n . V of a unit normal from the radiance coefficients of y, z and x: its irradiance minus the opposite normal's.
INLINE Number3 excessIrradiance(Number3 normal, Number3 sh_y, Number3 sh_z, Number3 sh_x) {
  return (sh_y * normal.y + sh_z * normal.z + sh_x * normal.x) / kShLinear;
}
