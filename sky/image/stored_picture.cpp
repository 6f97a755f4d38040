// SPDX-License-Identifier: Apache-2.0
#include "sky/image/stored_picture.h"

#include <utility>

#include "sh/deterministic.h"
#include "sky/image/icc_profile.h"
#include "sky/image/orientation.h"

namespace welkin::image {
namespace {

/// Colours by Exif, which count where nothing else names any.
void applyExifColours(StoredPicture& picture) {
  // Adobe RGB (1998) Color Image Encoding, version 2005-05, 4.3.1: 2 + 51/256.
  constexpr Chromaticities kAdobeRgb{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, {0.3127, 0.3290}};
  constexpr double kAdobeGamma = 2.19921875;
  if (picture.exif.colours == ExifColours::unsaid || !picture.icc.empty() || picture.colours || picture.gamma != 0.0)
    return;
  if (picture.exif.colours == ExifColours::uncalibrated) {
    picture.image.notes.push_back("Exif's ColorSpace is 65535, uncalibrated; without a profile sRGB is assumed");
    return;
  }
  picture.image.notes.push_back("Exif's ColorSpace and InteroperabilityIndex say Adobe RGB (1998)");
  picture.colours = kAdobeRgb;
  picture.gamma = kAdobeGamma;
}

}  // namespace

Image decoded(const std::string& name, StoredPicture picture, bool linear_codes) {
  if (linear_codes) {
    picture.icc.clear();
    picture.colours.reset();
    picture.gamma = 1.0;
  }
  applyExifColours(picture);
  Image image = std::move(picture.image);
  if (!picture.icc.empty()) {
    applyIccProfile(name, picture.icc, image);
  } else {
    if (picture.gamma != 1.0)
      for (float& value : image.rgb)
        value = static_cast<float>(picture.gamma == 0.0 ? det::srgbDecode(double{value})
                                                        : det::pow(double{value}, picture.gamma));
    if (picture.colours) convertColours(name, *picture.colours, image);
  }
  turnUpright(orientationOfTag(picture.exif.orientation), image);
  return image;
}

}  // namespace welkin::image
