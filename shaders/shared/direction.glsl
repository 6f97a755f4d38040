// SPDX-License-Identifier: Apache-2.0
// Angles and directions. World axes: +x east, +y up, -z north. A direction points away from the observer.
// Azimuth: radians clockwise from north; elevation: radians above the horizon.

// Unit direction of (azimuth, elevation), radians.
INLINE Number3 directionOf(Number azimuth_rad, Number elevation_rad) {
  Number c = cos(elevation_rad);
  return Number3(c * sin(azimuth_rad), sin(elevation_rad), -c * cos(azimuth_rad));
}

// Length of the horizontal part (x, z).
INLINE Number horizontalLength(Number3 direction) {
  return sqrt(direction.x * direction.x + direction.z * direction.z);
}

// Elevation of a direction, radians in [-pi/2, pi/2]; accurate at the poles, where asin(y) is not.
INLINE Number elevationOf(Number3 direction) { return atan(direction.y, horizontalLength(direction)); }

// Angle between two unit vectors, radians in [0, pi]: the half-angle form (Kahan 2006), accurate near 0 and pi, where
// the arc cosine of a dot product loses half its digits.
INLINE Number angleBetween(Number3 a, Number3 b) {
  Number3 d = a - b;
  Number3 s = a + b;
  return NUMBER(2.0) * atan(sqrt(dot(d, d)), sqrt(dot(s, s)));
}

// Direction of a light at hour angle `hour_angle_rad` (0 when it crosses the meridian, growing by 2 pi a day) and
// `declination_rad`, seen from `latitude_rad`, with the world's -z turned `north_offset_rad` from true north, so that
// azimuths grow by it. Geometric: without refraction or parallax. Meeus, Astronomical Algorithms (1998), ch. 13.
INLINE Number3 celestialDirection(Number hour_angle_rad, Number declination_rad, Number latitude_rad,
                                  Number north_offset_rad) {
  Number east = -cos(declination_rad) * sin(hour_angle_rad);
  Number up = sin(latitude_rad) * sin(declination_rad) + cos(latitude_rad) * cos(declination_rad) * cos(hour_angle_rad);
  Number north =
      cos(latitude_rad) * sin(declination_rad) - sin(latitude_rad) * cos(declination_rad) * cos(hour_angle_rad);
  Number c = cos(north_offset_rad);
  Number s = sin(north_offset_rad);
  return Number3(east * c + north * s, up, -(north * c - east * s));
}

// The inverse of celestialDirection: (cos dec cos H, sin dec, cos dec sin H) of a unit direction's declination and hour
// angle.
INLINE Number3 equatorialOf(Number3 direction, Number latitude_rad, Number north_offset_rad) {
  Number c = cos(north_offset_rad);
  Number s = sin(north_offset_rad);
  Number east = direction.x * c + direction.z * s;
  Number north = direction.x * s - direction.z * c;
  return Number3(cos(latitude_rad) * direction.y - sin(latitude_rad) * north,
                 sin(latitude_rad) * direction.y + cos(latitude_rad) * north, -east);
}
