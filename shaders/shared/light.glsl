// SPDX-License-Identifier: Apache-2.0
// Light that a surface receives from the sun or the moon, and light that level ground reflects.

// RGB irradiance of a surface that faces a light of this illuminance. Only hue and saturation of `colour` count; a black
// one gives 0.
INLINE Number3 normalIrradiance(Number3 colour, Number illuminance) {
  Number y = luminanceOf(colour);
  if (!(y > NUMBER(0.0))) return Number3(NUMBER(0.0));
  return colour * (illuminance / y);
}

// Irradiance of level ground from a light in a unit direction; 0 below the horizon.
INLINE Number3 levelIrradiance(Number3 normal_irradiance, Number3 direction) {
  return normal_irradiance * max(direction.y, NUMBER(0.0));
}

// Radiance of Lambertian ground by its albedo and its irradiance, pi included.
INLINE Number3 groundRadiance(Number3 albedo, Number3 horizontal_irradiance) {
  return albedo * horizontal_irradiance / kPi;
}
