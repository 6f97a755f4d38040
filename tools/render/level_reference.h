// SPDX-License-Identifier: Apache-2.0
// The irradiance of a picture's surfaces by the path tracer of probes/reference, which LevelView::draw then shows.
#pragma once

#include "probes/reference/light_path.h"
#include "render/camera.h"
#include "render/level_volume.h"
#include "render/offscreen.h"
#include "sky/base/progress.h"

namespace welkin::render {

struct TraceSettings {
  std::size_t paths = 64;   ///< of a pixel of the picture, at least; rounded up to 2 k^2 of each sample of it
  uint32_t samples = 2;     ///< of a pixel, along each side
  ProbeParts parts{};       ///< factors on the ambient light, as those of a view with probes
  bool direct = true;       ///< with sun, moon and the level's lamps
  double lowest_m = -1e30;  ///< surfaces below this height are left out
};

struct TracedImage {
  FloatImage irradiance;     ///< rgb, alpha 1; all 0 where there is no surface
  std::vector<float> error;  ///< of each texel: half the difference of its two halves' luminance, so a standard error
  std::size_t paths = 0;     ///< of a pixel
};

/// Traces every surface of LevelView::drawPlaces() from its camera, in parallel (oneTBB's current arena). The result is
/// the same for any number of threads. Normals are the picture's own, smooth ones. Throws what the progress throws.
TracedImage traceSurfaces(const reference::PathScene& scene, const FloatImage& places, const Camera& camera,
                          const f64::Number3& position, const TraceSettings& settings, const base::Progress& progress);

}  // namespace welkin::render
