// SPDX-License-Identifier: Apache-2.0
// A float image of the host as a texture that shaders fetch.
#pragma once

#include "render/image.h"
#include "render/offscreen.h"

namespace welkin::render {

class FloatTexture {
 public:
  /// Copies the image to the device and waits.
  FloatTexture(VulkanDevice& device, const FloatImage& image);

  const Image& image() const { return image_; }

 private:
  Image image_;
};

}  // namespace welkin::render
