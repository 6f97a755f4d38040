// SPDX-License-Identifier: Apache-2.0
// Fields of an EXR header that say more of the numbers than Welkin applies.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include "sky/image/image.h"

namespace welkin::image {

/// Adds a note for each of whiteLuminance, pixelAspectRatio, adoptedNeutral and Orientation that would change the
/// picture. Without chromaticities also for names of colour spaces (colorInteropID, colorSpace, oiio:ColorSpace) other
/// than linear Rec. 709's, and for acesImageContainerFlag, whose standard demands chromaticities (SMPTE ST 2065-4).
void noteUnusedFields(const Imf::Header& header, Image& image);

}  // namespace welkin::image
