// SPDX-License-Identifier: Apache-2.0
#include "sky/image/stored_picture.h"

#include <utility>

#include "sh/deterministic.h"
#include "sky/image/icc_profile.h"
#include "sky/image/orientation.h"

namespace welkin::image {

Image decoded(const std::string& name, StoredPicture picture) {
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
  turnUpright(orientationOfTag(picture.orientation), image);
  return image;
}

}  // namespace welkin::image
