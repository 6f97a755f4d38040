// SPDX-License-Identifier: Apache-2.0
// Diffuse light that wraps around a surface, with the energy of Lambert's: McAuley, "Energy-Conserving Wrapped Diffuse",
// 2011, and "Extension to Energy-Conserving Wrapped Diffuse", 2013. Each function is pi times the reflected share of a
// white surface, the cosine included: multiply by colour and by radiance over pi. Its mean over the sphere of light
// directions times 4 is 1, as for max(n.l, 0). n_dot_l is in [-1, 1]. w in [0, 1] is how far the light wraps, from
// Lambert's edge to the whole sphere; other values count as the nearer of these.

// max(n.l + w, 0)/(1 + w)^2. Without the square it would reflect 1 + w times what arrives.
INLINE Number wrappedDiffuse(Number n_dot_l, Number w) {
  Number wrap = clamp(w, NUMBER(0.0), NUMBER(1.0));
  Number around = NUMBER(1.0) + wrap;
  return max(n_dot_l + wrap, NUMBER(0.0)) / (around * around);
}

// The same with a wrap of each channel, as for skin, whose red light goes farthest.
INLINE Number3 wrappedDiffuseOf(Number n_dot_l, Number3 w) {
  return Number3(wrappedDiffuse(n_dot_l, w.x), wrappedDiffuse(n_dot_l, w.y), wrappedDiffuse(n_dot_l, w.z));
}

// The height of the lit part, ((n.l + w)/(1 + w))^n, 0 where there is no light. For n below 0 it grows without bound
// towards the edge, which is cut at 1e-30 of the height.
INLINE Number wrappedPower(Number n_dot_l, Number w, Number n) {
  Number wrap = clamp(w, NUMBER(0.0), NUMBER(1.0));
  Number height = (n_dot_l + wrap) / (NUMBER(1.0) + wrap);
  return height > NUMBER(0.0) ? pow(clamp(height, NUMBER(1e-30), NUMBER(1.0)), n) : NUMBER(0.0);
}

// The power form (n + 1)/(2 (1 + w)) ((n.l + w)/(1 + w))^n, for n > -1; a smaller n counts as -1, which reflects nothing:
// towards it all light gathers at the edge. n above 1e6 counts as that, a mirror's peak. n = 1 is wrappedDiffuse().
INLINE Number wrappedDiffusePower(Number n_dot_l, Number w, Number n) {
  Number power = clamp(n, NUMBER(-1.0), NUMBER(1e6));
  Number wrap = clamp(w, NUMBER(0.0), NUMBER(1.0));
  return (power + NUMBER(1.0)) / (NUMBER(2.0) * (NUMBER(1.0) + wrap)) * wrappedPower(n_dot_l, wrap, power);
}

// For comparison, Valve's half-Lambert, ((n.l + 1)/2)^2, which reflects 4/3 of what arrives: Mitchell, McTaggart and
// Green, "Shading in Valve's Source Engine", 2006.
INLINE Number halfLambert(Number n_dot_l) { return wrappedPower(n_dot_l, NUMBER(1.0), NUMBER(2.0)); }

// For comparison, ((n.l + a)/(1 + a))^(1 + a), which reflects 2 (1 + a)/(2 + a) of what arrives: Sloan, Nowrouzezahrai
// and Yuan, "Wrap Shading", 2011.
INLINE Number sloanWrapped(Number n_dot_l, Number a) {
  return wrappedPower(n_dot_l, a, NUMBER(1.0) + clamp(a, NUMBER(0.0), NUMBER(1.0)));
}
