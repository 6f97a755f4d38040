// SPDX-License-Identifier: Apache-2.0
// What light does at a surface that a ray met.
#include "probes/geometry/surface_at.h"
#include "probes/geometry/tracer.h"
#include "probes/geometry/tracer_scene.h"

namespace welkin::geometry {

Number3 Tracer::passing(const Hit& hit) const {
  const Triangle& triangle = surfaces().triangle[hit.triangle];
  const Material& material = surfaces().material[triangle.material];
  if (!material.letsLightThrough()) return Number3(0.0);
  const Texel surface = surfaceAt(surfaces(), triangle, {hit.u, hit.v});
  const double there = material.blended ? surface.alpha : 1.0;
  return surface.colour * (there * material.transmission) + Number3(1.0 - there);
}

Number3 Tracer::albedo(const Hit& hit) const {
  if (hit.back) return Number3(0.0);
  const Triangle& triangle = surfaces().triangle[hit.triangle];
  const Material& material = surfaces().material[triangle.material];
  const Texel surface = surfaceAt(surfaces(), triangle, {hit.u, hit.v});
  if (!material.letsLightThrough()) return surface.colour;
  return surface.colour * ((material.blended ? surface.alpha : 1.0) * (1.0 - material.transmission));
}

Number3 Tracer::emission(const Hit& hit) const {
  if (hit.back) return Number3(0.0);
  const Triangle& triangle = surfaces().triangle[hit.triangle];
  const Material& material = surfaces().material[triangle.material];
  if (material.emission == Number3(0.0)) return material.emission;
  Number3 emission = material.emission;
  if (material.emission_texture >= 0 && !surfaces().uv.empty())
    emission = emission * texelOf(surfaces(), triangle, Barycentric(hit.u, hit.v), material.emission_texture,
                                  material.emission_uv_row)
                              .colour;
  if (material.blended) emission *= surfaceAt(surfaces(), triangle, {hit.u, hit.v}).alpha;
  return emission;
}

}  // namespace welkin::geometry
