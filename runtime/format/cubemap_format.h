// SPDX-License-Identifier: Apache-2.0
// The formats of a cubemap's texels: files hold them, devices filter them, the bake encodes them. Vulkan 1.3,
// "Formats"; RGB9E5 by its "RGB to Shared Exponent Conversion", the small floats rounded to the nearest, ties to even.
#pragma once

#include <cstddef>
#include <cstdint>

namespace welkin::format {

/// Values of cubemap_format in welkin.fbs; all little-endian. Relative errors are of a component that is neither past
/// the largest nor below the smallest normal number; an RGB9E5 texel's are of its largest component.
enum class CubemapFormat : std::uint8_t {
  rgba16f = 0,   ///< VK_FORMAT_R16G16B16A16_SFLOAT, alpha 1: 8 bytes, error 2^-11
  rgb9e5 = 1,    ///< VK_FORMAT_E5B9G9R9_UFLOAT_PACK32: 4 bytes, error 2^-9
  b10g11r11 = 2  ///< VK_FORMAT_B10G11R11_UFLOAT_PACK32: 4 bytes, error 2^-7, of blue 2^-6
};
inline constexpr int kCubemapFormats = 3;

/// The most bytes of a texel.
inline constexpr std::size_t kMostTexelBytes = 8;

constexpr std::size_t texelBytes(CubemapFormat format) {
  return format == CubemapFormat::rgba16f ? 8 : 4;
}

/// Texels of the six faces of a cubemap of `size` texels along an edge, at most 65536.
constexpr std::uint64_t texelsOfCubemap(std::uint64_t size) {
  return 6 * size * size;
}
/// Bytes of the texels of `count` such cubemaps, without mips: what a file holds.
constexpr std::uint64_t bytesOfCubemaps(CubemapFormat format, std::uint64_t size, std::uint64_t count = 1) {
  return count * texelsOfCubemap(size) * texelBytes(format);
}

/// Its name in sky.toml and in reports.
constexpr const char* nameOf(CubemapFormat format) {
  return format == CubemapFormat::rgba16f ? "rgba16f" : format == CubemapFormat::rgb9e5 ? "rgb9e5" : "b10g11r11";
}

/// Largest value of a channel, 0 to 2: 65504; 65408; 65024 and, of blue, 64512.
constexpr float largestOf(CubemapFormat format, int channel) {
  return format == CubemapFormat::rgba16f  ? 65504.0F
         : format == CubemapFormat::rgb9e5 ? 65408.0F
         : channel == 2                    ? 64512.0F
                                           : 65024.0F;
}

/// Linear RGB of a texel; alpha is left out. Exact. Any bytes: those that hasOnlyLight refuses decode to something.
void decodeTexel(CubemapFormat format, const unsigned char* texel, float (&rgb)[3]);

/// The texel nearest to `rgb`: texelBytes(format) bytes at `texel`. Components past largestOf become it and are
/// counted; those below 0, and NaN, become 0. The same bits on every machine. Returns the count.
std::size_t encodeTexel(CubemapFormat format, const float (&rgb)[3], unsigned char* texel);

/// Whether no component of `count` texels is negative, infinite or NaN. Every RGB9E5 texel is so.
bool hasOnlyLight(CubemapFormat format, const unsigned char* texels, std::size_t count);

}  // namespace welkin::format
