// SPDX-License-Identifier: Apache-2.0
// The formats of a cubemap's texels: the bake encodes them, files hold them, devices filter them. Source: Vulkan 1.3,
// "Formats". RGB9E5 follows its "RGB to Shared Exponent Conversion"; small floats are rounded to nearest, ties to even.
#pragma once

#include <cstddef>
#include <cstdint>

namespace welkin::format {

/// Values of cubemap_format in welkin.fbs; all are little-endian. The errors below are relative, for a component
/// between the smallest normal number and the largest number. For RGB9E5 they are relative to the texel's largest
/// component.
enum class CubemapFormat : std::uint8_t {
  rgba16f = 0,   ///< VK_FORMAT_R16G16B16A16_SFLOAT, alpha 1: 8 bytes, error 2^-11
  rgb9e5 = 1,    ///< VK_FORMAT_E5B9G9R9_UFLOAT_PACK32: 4 bytes, error 2^-9
  b10g11r11 = 2  ///< VK_FORMAT_B10G11R11_UFLOAT_PACK32: 4 bytes, error 2^-7, for blue 2^-6
};
inline constexpr int kCubemapFormats = 3;

/// Size of the largest texel, bytes.
inline constexpr std::size_t kMostTexelBytes = 8;

constexpr std::size_t texelBytes(CubemapFormat format) {
  return format == CubemapFormat::rgba16f ? 8 : 4;
}

/// Number of texels in the six faces of a cubemap with `size` texels along an edge; `size` is at most 65536.
constexpr std::uint64_t texelsOfCubemap(std::uint64_t size) {
  return 6 * size * size;
}
/// Bytes of the texels of `count` such cubemaps in a file, without mips.
constexpr std::uint64_t bytesOfCubemaps(CubemapFormat format, std::uint64_t size, std::uint64_t count = 1) {
  return count * texelsOfCubemap(size) * texelBytes(format);
}

/// Name of the format in sky.toml and in reports.
constexpr const char* nameOf(CubemapFormat format) {
  return format == CubemapFormat::rgba16f ? "rgba16f" : format == CubemapFormat::rgb9e5 ? "rgb9e5" : "b10g11r11";
}

/// Largest value of a channel, 0 to 2: 65504 (rgba16f); 65408 (rgb9e5); 65024, and 64512 for blue (b10g11r11).
constexpr float largestOf(CubemapFormat format, int channel) {
  return format == CubemapFormat::rgba16f  ? 65504.0F
         : format == CubemapFormat::rgb9e5 ? 65408.0F
         : channel == 2                    ? 64512.0F
                                           : 65024.0F;
}

/// Linear RGB of a texel, exact; alpha is left out. Any bytes are allowed, even those that hasOnlyLight refuses.
void decodeTexel(CubemapFormat format, const unsigned char* texel, float (&rgb)[3]);

/// Writes the texel nearest to `rgb`: texelBytes(format) bytes at `texel`. Components above largestOf become largestOf;
/// negative ones and NaN become 0. Returns the number of components above largestOf. The same bits on every machine.
std::size_t encodeTexel(CubemapFormat format, const float (&rgb)[3], unsigned char* texel);

/// Whether no component of `count` texels is negative, infinite or NaN. True for all RGB9E5 texels.
bool hasOnlyLight(CubemapFormat format, const unsigned char* texels, std::size_t count);

}  // namespace welkin::format
