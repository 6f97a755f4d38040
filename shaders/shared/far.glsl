// SPDX-License-Identifier: Apache-2.0
// Share of the open sky's light that places beyond the volume of probes get, for C++ and GLSL. Stefanov, "Deferred
// Radiance Transfer Volumes" (GDC 2012): a map from above holds the sky's visibility and the height that it holds for,
// and the effect fades with the difference of heights. Files that need these formulas include this one beside
// formulas.glsl.

// Share of the effect at a height above or below the map's, in [0, 1]: 1 up to half of fade_m, 0 from fade_m on.
INLINE Number farFade(Number above_m, Number fade_m) {
  return clamp(NUMBER(2.0) - NUMBER(2.0) * max(above_m, -above_m) / fade_m, NUMBER(0.0), NUMBER(1.0));
}

// The sky's visibility at height y, in [0, 1]. The map has occlusion, 1 - visibility, and occlusion times height, both
// filtered: so open texels, whose occlusion is 0, have no height of their own. `share` is that of the map, in [0, 1].
INLINE Number farVisibility(Number occlusion, Number occluded_height_m, Number y, Number fade_m, Number share) {
  Number height_m = occluded_height_m / max(occlusion, NUMBER(1e-6));
  return NUMBER(1.0) - share * occlusion * farFade(y - height_m, fade_m);
}
