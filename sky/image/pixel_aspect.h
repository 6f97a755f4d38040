// SPDX-License-Identifier: Apache-2.0
// The shape of pixels by the header of a picture. Layouts of the sphere and gradients do not use it.
#pragma once

#include <string>

#include "sky/image/image.h"

namespace welkin::image {

/// Adds a note that names the field, if its pixels are not square. `aspect` is their width over their height.
void notePixelAspect(const std::string& field, double aspect, Image& image);

}  // namespace welkin::image
