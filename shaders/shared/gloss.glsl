// SPDX-License-Identifier: Apache-2.0
// Gloss, roughness and the power of Blinn-Phong's lobe, for C++ and GLSL, and what bumps that a filtered normal has lost
// do to that power.

// Doublings of the specular power between gloss 0 and 1: m = 2^(13 g), from 1 to 8192 (McAuley, "Calibrating Lighting
// and Materials in Far Cry 3", 2012).
CONSTANT Number kGlossDoublings = NUMBER(13.0);
CONSTANT Number kLargestPower = NUMBER(8192.0);

// Specular power of a gloss in [0, 1].
INLINE Number powerOfGloss(Number gloss) { return pow(NUMBER(2.0), kGlossDoublings * gloss); }

// Gloss of a power. A power below 1 counts as 1 and one above 8192 as 8192, so the result is in [0, 1].
INLINE Number glossOfPower(Number power) {
  Number doublings = log(clamp(power, NUMBER(1.0), kLargestPower)) / NUMBER(0.693147180559945309417);
  return clamp(doublings / kGlossDoublings, NUMBER(0.0), NUMBER(1.0));
}

// Power of the lobe as wide as glTF's: roughness r in [0, 1], alpha = r^2 and alpha^2 = 2 / (m + 2) (Walter et al.,
// "Microfacet Models for Refraction through Rough Surfaces", 2007, 5.2). Held to [1, 8192], as gloss can say no other.
INLINE Number powerOfRoughness(Number roughness) {
  Number square = roughness * roughness;
  Number least = NUMBER(2.0) / (kLargestPower + NUMBER(2.0));
  return clamp(NUMBER(2.0) / max(square * square, least) - NUMBER(2.0), NUMBER(1.0), kLargestPower);
}

// Roughness of a power >= 1: the inverse of powerOfRoughness, from 0.016^(1/2) to (2/3)^(1/4).
INLINE Number roughnessOfPower(Number power) { return sqrt(sqrt(NUMBER(2.0) / (power + NUMBER(2.0)))); }

// Power m' of a lobe of power m over bumps whose unit normals have a mean of length |na|: m' = |na| m / (|na| + m (1 -
// |na|)) (Toksvig, "Mipmapping Normal Maps", 2004). Equals 1/m' = 1/m + (1 - |na|)/|na|: variances add. The length is
// held to [0, 1], beyond which the formula has a pole, and m' to at least 1, which is gloss 0.
INLINE Number toksvigPower(Number power, Number mean_length) {
  Number na = clamp(mean_length, NUMBER(0.0), NUMBER(1.0));
  return max(na * power / (na + power * (NUMBER(1.0) - na)), NUMBER(1.0));
}
