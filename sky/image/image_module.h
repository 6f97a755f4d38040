// SPDX-License-Identifier: Apache-2.0
// Welkin's use of OpenImageIO and libwebp, as a module that is loaded when the first image is read or written. Linking
// OpenImageIO pulls in some two hundred libraries, and loading them costs more than most bakes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sky/image/coded_image.h"
#include "sky/image/image.h"

namespace welkin::image {

/// Every function throws Error(content) for bad content of an image and Error(internal) for a failed encoding.
struct ImageModule {
  Image (*read)(const std::filesystem::path& path, const char* format, const ImageLimits& limits);
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
