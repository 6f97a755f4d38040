// SPDX-License-Identifier: Apache-2.0
// Microfacet specular reflection with Blinn-Phong's lobe: every piece of McAuley, "Calibrating Lighting and Materials in
// Far Cry 3", SIGGRAPH 2012 course notes, section "Shading", and the forms beside it. f = F D V / 4, in 1/sr, for
// radiometric lights: notes that count lights pi times too bright leave pi out. m is the specular power in [1, 8192] and
// c the specular colour, the reflectance at normal incidence. Cosines of n.h and h.v are in [0, 1]; those of n.l and n.v
// may be below 0, where f is 0.

// Half vector of the unit directions to light and viewer. Zero for opposite ones, for which all lobes are 0.
INLINE Number3 halfVector(Number3 l, Number3 v) {
  Number3 sum = l + v;
  return sum / sqrt(max(dot(sum, sum), NUMBER(1e-30)));
}

// Fresnel's share of white, 1 at grazing incidence: Schlick, "An Inexpensive BRDF Model for Physically-Based Rendering",
// 1994, eq. 15.
INLINE Number schlickShare(Number h_dot_v) {
  Number x = NUMBER(1.0) - h_dot_v;
  return x * x * x * x * x;
}

// The spherical Gaussian of the notes for it, e^(-6 h.v): Lagarde, "Spherical Gaussian approximation for Blinn-Phong,
// Phong and Fresnel", 2011. At most 0.0417 off Schlick's, at h.v = 0.102, and e^-6 instead of 0 at normal incidence.
INLINE Number gaussianShare(Number h_dot_v) { return exp(NUMBER(-6.0) * h_dot_v); }

// The later Gaussian with a quadratic exponent, 2^((-5.55473 h.v - 6.98316) h.v): Lagarde 2012; Karis, "Real Shading in
// Unreal Engine 4", 2013. At most 0.0038 off Schlick's.
INLINE Number laterGaussianShare(Number h_dot_v) {
  return pow(NUMBER(2.0), (NUMBER(-5.55473) * h_dot_v - NUMBER(6.98316)) * h_dot_v);
}

// Reflectance of a specular colour and a share of white.
INLINE Number3 fresnel(Number3 c, Number share) { return c + (Number3(1.0) - c) * share; }

// Blinn-Phong's distribution of half vectors, (m + 2)/(2 pi) (n.h)^m, in 1/sr: the integral of D (n.h) is 1. The notes
// print (n.v) for (n.h) in D/4.
INLINE Number blinnPhong(Number m, Number n_dot_h) {
  return (m + NUMBER(2.0)) / kTwoPi * pow(n_dot_h, m);
}

// Roughness of Schlick-Smith's visibility, a = 1/sqrt(pi m/4 + pi/2): sqrt(2/pi) times Beckmann's roughness of that power
// (Lazarov, "Physically Based Lighting in Call of Duty: Black Ops", 2011). In [0.0124, 0.652].
INLINE Number smithRoughness(Number m) { return NUMBER(1.0) / sqrt(kPi / NUMBER(4.0) * m + kHalfPi); }

// Schlick-Smith's visibility V = G/(n.l n.v), for cosines in [0, 1] and a in (0, 1].
INLINE Number schlickSmith(Number a, Number n_dot_l, Number n_dot_v) {
  Number b = NUMBER(1.0) - a;
  return NUMBER(1.0) / ((n_dot_l * b + a) * (n_dot_v * b + a));
}

// Mean of that visibility over the hemispheres of light and of view, (ln a/(1 - a))^2. It is a double mean, which the
// notes print with one integral. 1 at a = 1.
INLINE Number meanVisibility(Number a) {
  Number b = NUMBER(1.0) - a;
  // Near 1 the quotient is 0/0; its series is right to b^3/4 of the value.
  Number root = b < NUMBER(0.01) ? NUMBER(1.0) + b * (NUMBER(0.5) + b / NUMBER(3.0)) : -log(a) / b;
  return root * root;
}

// E(g) = (m + 2)/8 times the mean visibility, for gloss in [0, 1]: pi/4 D at its peak under the mean V.
INLINE Number meanFactor(Number gloss) {
  Number m = powerOfGloss(gloss);
  return (m + NUMBER(2.0)) / NUMBER(8.0) * meanVisibility(smithRoughness(m));
}

// E'(g) = 2^(16.1624 g - 1.85689), the notes' fit of E. It is a fit of absolute error: 51 % too low at gloss 0, up to
// 18 % too high at 0.31, within 1.7 % from 0.7.
INLINE Number fittedFactor(Number gloss) {
  return pow(NUMBER(2.0), NUMBER(16.1624) * gloss - NUMBER(1.85689));
}

// The family (alpha m + beta)/8, all of whose candidates are 3/8 at gloss 0: (8, -5), (4, -1), (2, 1) and (1, 2), of
// which the last is V = 1.
INLINE Number linearFactor(Number m, Number alpha, Number beta) { return (alpha * m + beta) / NUMBER(8.0); }

// The factor that Far Cry 3 shipped, (2 m + 1)/8. Reflects up to twice what arrives, so c of at most 0.499 conserves
// energy for every m.
INLINE Number shippedFactor(Number m) { return linearFactor(m, NUMBER(2.0), NUMBER(1.0)); }

// The lobe alone for a factor, 1/sr: factor/pi (n.h)^m in front of the surface, 0 behind it.
INLINE Number factoredLobe(Number factor, Number m, Number n_dot_l, Number n_dot_v, Number n_dot_h) {
  bool front = n_dot_l > NUMBER(0.0) && n_dot_v > NUMBER(0.0);
  return front ? factor / kPi * pow(max(n_dot_h, NUMBER(0.0)), m) : NUMBER(0.0);
}

// The lobe under Schlick-Smith's visibility: D V / 4.
INLINE Number schlickSmithLobe(Number m, Number n_dot_l, Number n_dot_v, Number n_dot_h) {
  Number visible = schlickSmith(smithRoughness(m), max(n_dot_l, NUMBER(0.0)), max(n_dot_v, NUMBER(0.0)));
  return factoredLobe((m + NUMBER(2.0)) / NUMBER(8.0) * visible, m, n_dot_l, n_dot_v, n_dot_h);
}

// Lambert's reflection of a diffuse colour, 1/sr.
INLINE Number3 lambert(Number3 c) { return c / kPi; }

// Specular reflection as shipped: spherical Gaussian and (2 m + 1)/8. n, l and v are unit vectors away from the surface.
INLINE Number3 shippedSpecular(Number3 c, Number m, Number3 n, Number3 l, Number3 v) {
  Number3 h = halfVector(l, v);
  Number share = gaussianShare(clamp(dot(h, v), NUMBER(0.0), NUMBER(1.0)));
  return fresnel(c, share) * factoredLobe(shippedFactor(m), m, dot(n, l), dot(n, v), dot(n, h));
}

// Specular reflection in full: Schlick's Fresnel and Schlick-Smith's visibility. Conserves energy for every m and c.
INLINE Number3 schlickSmithSpecular(Number3 c, Number m, Number3 n, Number3 l, Number3 v) {
  Number3 h = halfVector(l, v);
  Number share = schlickShare(clamp(dot(h, v), NUMBER(0.0), NUMBER(1.0)));
  return fresnel(c, share) * schlickSmithLobe(m, dot(n, l), dot(n, v), dot(n, h));
}
