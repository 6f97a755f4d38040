// SPDX-License-Identifier: Apache-2.0
// Welkin's use of OpenImageIO, as a module that is loaded when an image needs it: it reads TIFF, BMP, Targa and DDS,
// and writes PNG. Linking OpenImageIO pulls in some two hundred libraries, and loading them takes about a second.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sky/image/coded_image.h"
#include "sky/image/image.h"
#include "sky/image/stored_picture.h"

namespace welkin::image {

/// Every function throws Error(content) for bad content of an image and Error(internal) for a failed encoding.
struct ImageModule {
  StoredPicture (*read_tiff)(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits);
  CodedImage (*decode)(const std::string& name, const char* format, std::span<const std::byte> bytes,
                       const ImageLimits& limits);
  std::vector<std::byte> (*encode_png)(int width, int height, int bits, const void* rgb);
  void (*draw_caption)(int width, int height, std::uint8_t* rgb, const Caption& caption);
};

/// Loads the module once. Throws Error(file) when it is not beside the program.
const ImageModule& imageModule();

/// Name of the function that the module exports.
inline constexpr const char* kImageModuleEntry = "welkinImageModule";

}  // namespace welkin::image
