// SPDX-License-Identifier: Apache-2.0
#include "render/level_reference.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "render/place.h"

namespace welkin::render {
namespace {

using f64::Number3;

Number3 scaledSum(const reference::LightShares& light, const ProbeParts& parts) {
  return light.sky * double{parts.sky} + light.sun_bounce * double{parts.sun_bounce} +
         light.local * double{parts.local};
}

}  // namespace

TracedImage traceSurfaces(const reference::PathScene& scene, const FloatImage& places, const Camera& camera,
                          const Number3& position, const TraceSettings& settings, const base::Progress& progress) {
  const double texels_of_pixel = static_cast<double>(settings.samples * settings.samples);
  const auto strata = static_cast<std::size_t>(
      std::ceil(std::sqrt(static_cast<double>(settings.paths) / (2.0 * texels_of_pixel)) - 1e-9));
  TracedImage traced;
  traced.irradiance = {places.width, places.height, std::vector<float>(places.rgba.size())};
  traced.error.resize(places.rgba.size() / 4);
  traced.paths = 2 * strata * strata * settings.samples * settings.samples;
  const PlaceOf place_of(places, camera, position);
  const base::Progress rows = progress.stage("rows of the path tracer", places.height);
  tbb::parallel_for(uint32_t{0}, places.height, [&](uint32_t y) {
    for (uint32_t x = 0; x < places.width; ++x) {
      const auto place = place_of(x, y);
      if (!place || place->position.y < settings.lowest_m) continue;
      geometry::Hit start = scene.tracer.pointOn(place->position, place->normal);
      start.back_along = place->towards;
      const std::size_t texel = std::size_t{y} * places.width + x;
      const Number3 a = scaledSum(meanOfBatch(scene, start, strata, 0, 2 * texel), settings.parts);
      const Number3 b = scaledSum(meanOfBatch(scene, start, strata, 0, 2 * texel + 1), settings.parts);
      Number3 sum = (a + b) * 0.5;
      if (settings.direct) sum += directIrradiance(scene, start);
      float* out = traced.irradiance.rgba.data() + 4 * texel;
      for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(sum[c]);
      out[3] = 1.0F;
      traced.error[texel] = static_cast<float>(f64::luminanceOf(a - b) * 0.5);
    }
    rows.step();
  });
  return traced;
}

}  // namespace welkin::render
