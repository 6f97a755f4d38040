// SPDX-License-Identifier: Apache-2.0
// The dome as an EXR file: half floats, with the attributes envmap, chromaticities and whiteLuminance, without a date.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sky/base/progress.h"
#include "sky/cubemap/cubemap.h"

namespace welkin::cubemap {

/// The bytes of a scanline EXR, ZIP-compressed. `layout` is exr_cube or exr_latlong and becomes the `envmap` attribute;
/// without it the file has no such attribute. `luminance_unit` (cd/m2 of radiance 1) becomes `whiteLuminance`.
/// `progress` is asked now and then, as in bakeDayTable.
std::vector<std::byte> encodeExr(const DomeImage& image, std::optional<Layout> layout, double luminance_unit,
                                 const base::Progress& progress = {});

}  // namespace welkin::cubemap
