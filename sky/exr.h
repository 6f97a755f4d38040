// SPDX-License-Identifier: Apache-2.0
// EXR files of the dome: half floats, the envmap, chromaticities and whiteLuminance attributes, no dates.
#pragma once

#include <cstddef>
#include <vector>

#include "sky/cubemap.h"

namespace welkin::sky {

/// The bytes of a scanline EXR, ZIP-compressed. `layout` is exr_cube or exr_latlong and becomes the `envmap` attribute;
/// `luminance_unit` (cd/m2 of radiance 1) becomes `whiteLuminance`. `progress` is asked now and then, as in
/// bakeDayTable.
std::vector<std::byte> encodeExr(const DomeImage& image, Layout layout, double luminance_unit,
                                 const Progress& progress = {});

}  // namespace welkin::sky
