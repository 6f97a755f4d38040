// SPDX-License-Identifier: Apache-2.0
// EXR files: those of the dome, half floats with envmap, chromaticities and whiteLuminance attributes and no dates; and
// any that are read.
#pragma once

#include <cstddef>
#include <vector>

#include "sky/cubemap.h"
#include "sky/image.h"

namespace welkin::sky {

/// The bytes of a scanline EXR, ZIP-compressed. `layout` is exr_cube or exr_latlong and becomes the `envmap` attribute;
/// `luminance_unit` (cd/m2 of radiance 1) becomes `whiteLuminance`. `progress` is asked now and then, as in
/// bakeDayTable.
std::vector<std::byte> encodeExr(const DomeImage& image, Layout layout, double luminance_unit,
                                 const Progress& progress = {});

/// The channels R, G and B of a flat file's first part, or Y thrice, any type, as they are stored; and its `envmap`
/// attribute. readImage's part for this format, and its errors; the values are not looked at.
Image readExr(const std::filesystem::path& path, const ImageLimits& limits);

}  // namespace welkin::sky
