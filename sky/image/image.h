// SPDX-License-Identifier: Apache-2.0
// Colour images: read from PNG, OpenEXR, TIFF, JPEG, Radiance HDR and PNM files, written as PNG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace welkin::image {

/// OpenEXR's `envmap` attribute.
enum class EnvironmentMap { none, cube, latlong };

/// Linear Rec. 709, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
  EnvironmentMap envmap = EnvironmentMap::none;
  bool converted = false;          ///< whether the file's colours had other primaries
  std::vector<std::string> notes;  ///< for the user: header fields that changed the numbers, and parts left out
};

/// Limits on the size and values of an image.
struct ImageLimits {
  int largest_side = 16384;
  std::size_t most_texels = std::size_t{1} << 24;
  bool negative = false;  ///< whether finite values below 0 are allowed
  bool linear_codes =
      false;  ///< integer codes are light itself, in Rec. 709, whatever the file says of curve and colours
};

/// Decodes the bytes of a picture. Integer images are sRGB-encoded (IEC 61966-2-1) unless the file says linear or names
/// a gamma; floating-point images are linear. One channel is grey; alpha is ignored. The first bytes give the format,
/// whatever the name. `layer` selects a layer, view or part of an OpenEXR file by its name; if it is empty, the layer
/// without a name comes first, then the only one, then the only one that ends in "Combined".
/// Throws Error(content) for a damaged, cut or foreign file, a header that cannot be honoured, more texels than the
/// limits allow, or a value out of them; the message names the file, and for a value column, row (from the top),
/// channel and value.
Image readImage(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits = {},
                const std::string& layer = "");

/// Reads a file and decodes it. Throws Error(file) when it cannot be read.
Image readImage(const std::filesystem::path& path, const ImageLimits& limits = {}, const std::string& layer = "");

/// Reads a picture of numbers that are no light, such as normals, as its file stores them: codes divided by the largest
/// code, or floats. Upright; fields about colour are ignored. Reads PNG, OpenEXR, TIFF, JPEG, WebP, BMP, Targa and DDS,
/// the last four with 8 bits. One channel is grey; alpha is ignored. Throws as readImage does, and Error(content) for
/// an OpenEXR file whose colours would be converted.
Image readCodes(const std::filesystem::path& path, const ImageLimits& limits = {});

/// Encodes width x height sRGB-encoded RGB texels, rows from the top, as the bytes of a PNG.
std::vector<std::byte> encodePng(int width, int height, std::span<const std::uint8_t> rgb);
std::vector<std::byte> encodePng(int width, int height, std::span<const std::uint16_t> rgb);

/// A line of text centred on texel (x, y), `size` texels high, in the font of a TrueType file.
struct Caption {
  int x = 0;
  int y = 0;
  int size = 0;
  std::string text;
  std::string font;
};

/// Draws light grey text into width x height RGB texels.
void drawCaption(int width, int height, std::span<std::uint8_t> rgb, const Caption& caption);

}  // namespace welkin::image
