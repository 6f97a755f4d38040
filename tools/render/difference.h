// SPDX-License-Identifier: Apache-2.0
// The error of a drawn irradiance against the path tracer's, as numbers and as a picture in false colours.
#pragma once

#include <cstddef>
#include <string>

#include "render/level_reference.h"
#include "render/tone.h"

namespace welkin::render {

/// Errors are of luminance, over `unit`. A pixel has the mean of those of its samples that both images have.
struct IrradianceError {
  double unit = 0.0;   ///< mean luminance of the traced irradiance over the pixels, scene units
  double mean = 0.0;   ///< drawn minus traced
  double rms = 0.0;    ///< without the tracer's own noise
  double worst = 0.0;  ///< the largest, with its sign; the noise of its pixel included
  double noise = 0.0;  ///< rms of the tracer's standard error
  std::size_t pixels = 0;
};

/// `drawn` has alpha 1 on surfaces. Without a surface or light all is 0.
IrradianceError errorOf(const FloatImage& drawn, const TracedImage& traced, uint32_t samples);

/// Such as "rms 12.3 %, mean -1.2 %, worst +80 %".
std::string errorText(const IrradianceError& error);

/// Drawn minus traced: blue where too dark, white where equal, red where too bright, grey where nothing was traced.
/// Below are a scale and `error` in words, where the system has a font. The ends of the scale hold all but 2 % of the
/// pixels.
Picture differencePicture(const FloatImage& drawn, const TracedImage& traced, uint32_t samples,
                          const IrradianceError& error);

}  // namespace welkin::render
