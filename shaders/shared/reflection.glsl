// SPDX-License-Identifier: Apache-2.0
// Reflection of surroundings by a rough surface: the share of an even light that it reflects, which its diffuse part
// loses, and how dark the surroundings are. m and c are as in specular.glsl.

// Mip of a chain of `mips` >= 2 that is filtered for a gloss in [0, 1]: gloss 1 in mip 0, gloss 0 in the last.
INLINE Number mipOfGloss(Number gloss, Number mips) { return (NUMBER(1.0) - gloss) * (mips - NUMBER(1.0)); }

// Gloss of a mip of that chain.
INLINE Number glossOfMip(Number mip, Number mips) { return NUMBER(1.0) - mip / (mips - NUMBER(1.0)); }

// Share of an even light that the white lobe of specular.glsl reflects towards the viewer: the integral of
// schlickSmithLobe() n.l over the hemisphere. Fitted; within 0.019 of the integral for every gloss and cosine in [0, 1]
// (tests/materials/reflection_test.cpp). In the mirror's limit it is 1.
INLINE Number whiteShare(Number m, Number n_dot_v) {
  Number a = smithRoughness(m);
  Number across = NUMBER(0.5606) * a;
  Number mu = sqrt(n_dot_v * n_dot_v + across * across);
  Number p = a * (NUMBER(0.5010) + a * (NUMBER(1.9669) - NUMBER(2.3257) * a));
  Number r = a * (NUMBER(1.4019) + a * (NUMBER(0.6666) - NUMBER(6.2053) * a));
  Number s = a * (NUMBER(1.2009) + a * (NUMBER(1.7825) - NUMBER(4.0357) * a));
  Number q = (mu + p) / (mu * (NUMBER(1.0) - r) + p + s);
  return min(q * q, NUMBER(1.0));
}

// Mean of Schlick's share of white over the light that the lobe reflects, (1 - n.v)^5 in the mirror's limit. Fitted;
// times whiteShare() it is within 0.017 of the integral.
INLINE Number meanSchlickShare(Number m, Number n_dot_v) {
  Number a = smithRoughness(m);
  Number across = NUMBER(1.0251) * a;
  Number mu = sqrt(n_dot_v * n_dot_v + across * across);
  Number start = NUMBER(1.0) - a * (NUMBER(0.3789) + NUMBER(2.3544) * a);
  Number slope = NUMBER(1.0) + a * (NUMBER(3.5956) - NUMBER(7.5762) * a);
  Number bend = a * (NUMBER(6.6045) - NUMBER(0.3312) * a);
  Number x = clamp(start - mu * slope + bend * mu * (NUMBER(1.0) - mu), NUMBER(0.0), NUMBER(1.0));
  return x * x * x * x * x;
}

// Share of an even light that schlickSmithSpecular() reflects, for n.v in [0, 1]. Times the lobe's mean radiance it is
// the reflection of the surroundings, as a split sum: Karis, "Real Shading in Unreal Engine 4", 2013. What is left, 1
// minus it, is the share for the diffuse part: then no colour reflects more than arrives.
INLINE Number3 reflectedShare(Number3 c, Number m, Number n_dot_v) {
  return fresnel(c, meanSchlickShare(m, n_dot_v)) * whiteShare(m, n_dot_v);
}

// Share of the sky's reflection that is left where it is hidden: the irradiance of a place along the mirrored direction
// over that of the open sky, each channel at most 1. So no reflection is brighter than in the open, and in the dark it
// is 0.
INLINE Number openShareOf(Number place, Number open) {
  return open > NUMBER(0.0) ? clamp(place / open, NUMBER(0.0), NUMBER(1.0)) : NUMBER(0.0);
}
INLINE Number3 openShare(Number3 place, Number3 open) {
  return Number3(openShareOf(place.x, open.x), openShareOf(place.y, open.y), openShareOf(place.z, open.z));
}

// Specular colour of glTF's material, 0.04 for a dielectric and the base colour for a metal, and its diffuse colour.
INLINE Number3 specularColourOf(Number3 base, Number metallic) {
  return Number3(NUMBER(0.04)) * (NUMBER(1.0) - metallic) + base * metallic;
}
INLINE Number3 diffuseColourOf(Number3 base, Number metallic) { return base * (NUMBER(1.0) - metallic); }
