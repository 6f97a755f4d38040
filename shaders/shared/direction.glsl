// SPDX-License-Identifier: Apache-2.0
// Angles and directions. World axes: +x east, +y up, -z north. A direction points away from the observer.
// Azimuth: radians clockwise from north; elevation: radians above the horizon.

// Unit direction of (azimuth, elevation), radians.
INLINE Number3 directionOf(Number azimuth_rad, Number elevation_rad) {
  Number c = cos(elevation_rad);
  return Number3(c * sin(azimuth_rad), sin(elevation_rad), -c * cos(azimuth_rad));
}

// Sine, at least 0, of the angle with this cosine: the horizontal length of a unit direction by its y. 1 - cosine^2
// would lose digits near the poles; its two factors are exact there. A cosine that rounding took past 1 gives 0.
INLINE Number sineFromCosine(Number cosine) {
  return sqrt(max((NUMBER(1.0) - cosine) * (NUMBER(1.0) + cosine), NUMBER(0.0)));
}

// Length of the horizontal part (x, z).
INLINE Number horizontalLength(Number3 direction) {
  return sqrt(direction.x * direction.x + direction.z * direction.z);
}

// Elevation of a direction, radians in [-pi/2, pi/2]; accurate at the poles, where asin(y) is not.
INLINE Number elevationOf(Number3 direction) { return atan(direction.y, horizontalLength(direction)); }

// Angle between two unit vectors, radians in [0, pi]. The half-angle form (Kahan 2006) is accurate near 0 and pi, where
// the arc cosine of a dot product loses half its digits.
INLINE Number angleBetween(Number3 a, Number3 b) {
  Number3 d = a - b;
  Number3 s = a + b;
  return NUMBER(2.0) * atan(sqrt(dot(d, d)), sqrt(dot(s, s)));
}

// The daily circle of a declination: direction = centre + meridian cos H + west sin H at hour angle H.
struct DailyCircle {
  Number3 centre;
  Number3 meridian;
  Number3 west;
};

// The circle of `declination_rad` seen from `latitude_rad`. `north_offset_rad` is the world's azimuth of true north, so
// it is added to true azimuths. Geometric: without refraction or parallax. Meeus, Astronomical Algorithms (1998),
// ch. 13.
INLINE DailyCircle dailyCircle(Number declination_rad, Number latitude_rad, Number north_offset_rad) {
  Number c = cos(north_offset_rad);
  Number s = sin(north_offset_rad);
  Number3 north = Number3(s, NUMBER(0.0), -c);
  Number3 east = Number3(c, NUMBER(0.0), s);
  Number3 up = Number3(NUMBER(0.0), NUMBER(1.0), NUMBER(0.0));
  DailyCircle circle;
  circle.centre = (up * sin(latitude_rad) + north * cos(latitude_rad)) * sin(declination_rad);
  circle.meridian = (up * cos(latitude_rad) - north * sin(latitude_rad)) * cos(declination_rad);
  circle.west = -(east * cos(declination_rad));
  return circle;
}

// Unit direction at an hour angle, which is 0 when the light crosses the meridian and grows by 2 pi a day.
INLINE Number3 directionOnCircle(DailyCircle circle, Number hour_angle_rad) {
  return circle.centre + circle.meridian * cos(hour_angle_rad) + circle.west * sin(hour_angle_rad);
}

INLINE Number3 celestialDirection(Number hour_angle_rad, Number declination_rad, Number latitude_rad,
                                  Number north_offset_rad) {
  return directionOnCircle(dailyCircle(declination_rad, latitude_rad, north_offset_rad), hour_angle_rad);
}

// Inverse of celestialDirection. Returns (cos dec cos H, sin dec, cos dec sin H), where dec and H are the declination
// and the hour angle of a unit direction.
INLINE Number3 equatorialOf(Number3 direction, Number latitude_rad, Number north_offset_rad) {
  Number c = cos(north_offset_rad);
  Number s = sin(north_offset_rad);
  Number east = direction.x * c + direction.z * s;
  Number north = direction.x * s - direction.z * c;
  return Number3(cos(latitude_rad) * direction.y - sin(latitude_rad) * north,
                 sin(latitude_rad) * direction.y + cos(latitude_rad) * north, -east);
}
