// SPDX-License-Identifier: Apache-2.0
// The spherical harmonics of a baked sky at one time, as JSON.
#pragma once

#include <welkin/welkin.h>

#include <string>

namespace welkin::maps {

/// The text of the file: time, luminance unit, convention, and the coefficients of radiance by channel, before and
/// after the ambient desaturation. Coefficients are Welkin's: world axes, whatever engine the maps are for.
std::string shJson(const WelkinSkyInfo& info, const WelkinSkySample& sample);

}  // namespace welkin::maps
