// SPDX-License-Identifier: Apache-2.0
// Reads PNM and PFM pictures: P2, P3, P5 and P6 (Netpbm) and the floats of PF and Pf (P. Debevec).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sky/image/image.h"

namespace welkin::image {

/// readImage()'s part for PNM; it throws the same errors. Codes are sRGB-encoded, from 0 to the file's largest value, 1
/// to 65535. Floats are linear; the absolute value of their scale is a factor, and its sign gives the order of bytes.
Image readPnm(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits);

}  // namespace welkin::image
