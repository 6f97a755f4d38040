// SPDX-License-Identifier: Apache-2.0
#include "sky/image/dds_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace welkin::image {
namespace {

constexpr std::uint32_t fourCc(const char (&text)[5]) {
  std::uint32_t code = 0;
  for (unsigned i = 0; i < 4; ++i) code |= std::uint32_t{static_cast<unsigned char>(text[i])} << (8 * i);
  return code;
}

// Words of 4 bytes, counted from the start of the file.
constexpr std::size_t kHeight = 3, kWidth = 4, kPixelFlags = 20, kFourCc = 21, kBits = 22, kMasks = 23, kCaps2 = 28;
constexpr std::size_t kWords = 32, kDxgiWords = 37, kDxgi = 32, kDimension = 33, kMisc = 34, kArray = 35, kMisc2 = 36;
constexpr std::uint32_t kHasAlpha = 0x1, kIsFourCc = 0x4, kIsRgb = 0x40, kIsGrey = 0x20000;
constexpr std::uint32_t kAlphaMask = 0xff000000;

/// How the pixels are stored: blocks of 4 x 4, or bits by masks of red, green, blue and alpha.
struct Pixels {
  std::uint32_t flags = 0, four_cc = 0, bits = 0;
  std::array<std::uint32_t, 4> mask{};
  std::uint32_t dxgi = 0;  ///< 0: the header is of the old kind

  std::int64_t blockBytes() const { return four_cc == fourCc("DXT1") ? 8 : 16; }
};

std::uint32_t wordOf(std::span<const std::byte> file, std::size_t index) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(file[4 * index + i]) << (8 * i);
  return value;
}

bool hasDxgi(std::span<const std::byte> file) {
  return (wordOf(file, kPixelFlags) & kIsFourCc) != 0 && wordOf(file, kFourCc) == fourCc("DX10");
}

std::size_t headerBytes(std::span<const std::byte> file) {
  return 4 * (file.size() >= 4 * kWords && hasDxgi(file) ? kDxgiWords : kWords);
}

/// By the numbers of DXGI_FORMAT. Those of sRGB hold the same codes as those without: textures of colours are sRGB.
std::optional<Pixels> pixelsOfDxgi(std::uint32_t format) {
  constexpr std::uint32_t kBc7 = 98;
  constexpr std::array<std::uint32_t, 4> kRgba{0xff, 0xff00, 0xff0000, kAlphaMask};
  constexpr std::array<std::uint32_t, 4> kBgra{0xff0000, 0xff00, 0xff, kAlphaMask};
  switch (format) {
    case 71:
    case 72:
      return Pixels{kIsFourCc, fourCc("DXT1"), 0, {}, 0};
    case 74:
    case 75:
      return Pixels{kIsFourCc, fourCc("DXT3"), 0, {}, 0};
    case 77:
    case 78:
      return Pixels{kIsFourCc, fourCc("DXT5"), 0, {}, 0};
    case kBc7:
    case kBc7 + 1:
      return Pixels{kIsFourCc, fourCc("DX10"), 0, {}, kBc7};
    case 28:
    case 29:
      return Pixels{kIsRgb | kHasAlpha, 0, 32, kRgba, 0};
    case 87:
    case 91:
      return Pixels{kIsRgb | kHasAlpha, 0, 32, kBgra, 0};
    case 88:
    case 93:
      return Pixels{kIsRgb, 0, 32, kBgra, 0};
    default:
      return std::nullopt;
  }
}

/// Whether a mask is 1 to 8 neighbouring bits of those that a pixel has.
bool isChannel(std::uint32_t mask, std::uint32_t bits) {
  const auto used = static_cast<std::uint32_t>(std::bit_width(mask));
  const auto from = static_cast<std::uint32_t>(std::countr_zero(mask));
  return mask != 0 && used <= bits && used - from <= 8 && std::popcount(mask) == static_cast<int>(used - from);
}

/// Pixels of a header of the old kind.
std::optional<Pixels> pixelsOfOld(std::span<const std::byte> file) {
  Pixels pixels{wordOf(file, kPixelFlags) & (kHasAlpha | kIsFourCc | kIsRgb | kIsGrey), 0, 0, {}, 0};
  if ((pixels.flags & kIsFourCc) != 0) {
    const std::uint32_t code = wordOf(file, kFourCc);
    if (code != fourCc("DXT1") && code != fourCc("DXT3") && code != fourCc("DXT5")) return std::nullopt;
    return Pixels{kIsFourCc, code, 0, {}, 0};
  }
  pixels.bits = wordOf(file, kBits);
  for (std::size_t i = 0; i < 4; ++i) pixels.mask[i] = wordOf(file, kMasks + i);
  const bool alpha = (pixels.flags & kHasAlpha) != 0;
  auto& mask = pixels.mask;
  if (!alpha) mask[3] = 0;
  if ((pixels.flags & kIsGrey) != 0) {
    const bool plain = mask[0] == 0xff && pixels.bits == (alpha ? 16U : 8U) && mask[3] == (alpha ? 0xff00U : 0U);
    return plain ? std::optional(pixels) : std::nullopt;
  }
  if ((pixels.flags & kIsRgb) == 0) return std::nullopt;
  if (pixels.bits != 16 && pixels.bits != 24 && pixels.bits != 32) return std::nullopt;
  const bool channels = std::all_of(mask.begin(), mask.end() - (alpha ? 0 : 1),
                                    [&](std::uint32_t m) { return isChannel(m, pixels.bits); });
  return channels ? std::optional(pixels) : std::nullopt;
}

std::optional<Pixels> pixelsOf(std::span<const std::byte> file) {
  constexpr std::uint32_t kCubeOrVolume = 0x200 | 0x200000, kFlat = 3, kCube = 4, kAlphaMode = 7, kMultiplied = 2;
  if ((wordOf(file, kCaps2) & kCubeOrVolume) != 0) return std::nullopt;
  if (!hasDxgi(file)) return pixelsOfOld(file);
  if (wordOf(file, kDimension) != kFlat || (wordOf(file, kMisc) & kCube) != 0 || wordOf(file, kArray) > 1 ||
      (wordOf(file, kMisc2) & kAlphaMode) == kMultiplied)
    return std::nullopt;
  return pixelsOfDxgi(wordOf(file, kDxgi));
}

std::vector<std::byte> withHeader(const Pixels& pixels, std::uint32_t width, std::uint32_t height,
                                  std::span<const std::byte> texels) {
  constexpr std::uint32_t kCapsHeightWidthPixels = 0x1007, kTexture = 0x1000;
  std::array<std::uint32_t, kDxgiWords> word{fourCc("DDS "), 124, kCapsHeightWidthPixels};
  word[kHeight] = height;
  word[kWidth] = width;
  word[kPixelFlags - 1] = 32;
  word[kPixelFlags] = pixels.flags;
  word[kFourCc] = pixels.four_cc;
  word[kBits] = pixels.bits;
  std::copy(pixels.mask.begin(), pixels.mask.end(), word.begin() + kMasks);
  word[kCaps2 - 1] = kTexture;
  word[kDxgi] = pixels.dxgi;
  word[kDimension] = 3;
  word[kArray] = 1;
  std::vector<std::byte> file;
  for (std::size_t i = 0; i < (pixels.dxgi != 0 ? kDxgiWords : kWords); ++i)
    for (unsigned shift = 0; shift < 32; shift += 8) file.push_back(static_cast<std::byte>(word[i] >> shift));
  file.insert(file.end(), texels.begin(), texels.end());
  return file;
}

}  // namespace

bool isDds(std::span<const std::byte> file) {
  return file.size() >= 4 && wordOf(file, 0) == fourCc("DDS ");
}

bool isReadableDds(std::span<const std::byte> file) {
  return isDds(file) && (file.size() < headerBytes(file) || pixelsOf(file));
}

DdsLevel ddsLevel(std::span<const std::byte> file, int largest_side) {
  const auto header = static_cast<std::int64_t>(headerBytes(file));
  const auto size = static_cast<std::int64_t>(file.size());
  if (size < header) return {fmt::format("it has {} of the {} bytes of its header", size, header), {}};
  const std::optional<Pixels> pixels = pixelsOf(file);
  if (!pixels) return {"its pixels are of a kind that is not read", {}};
  if (wordOf(file, 1) != 124 || wordOf(file, kPixelFlags - 1) != 32)
    return {fmt::format("its header's sizes are {} and {}; 124 and 32 are allowed", wordOf(file, 1),
                        wordOf(file, kPixelFlags - 1)),
            {}};
  const std::int64_t width = wordOf(file, kWidth), height = wordOf(file, kHeight);
  if (width < 1 || height < 1 || std::max(width, height) > largest_side)
    return {fmt::format("{} x {} texels; 1 to {} a side are allowed", width, height, largest_side), {}};
  const std::int64_t bytes = pixels->four_cc != 0 ? ((width + 3) / 4) * ((height + 3) / 4) * pixels->blockBytes()
                                                  : width * height * (pixels->bits / 8);
  if (bytes > size - header)
    return {fmt::format("its texels take {} bytes; the file ends {} bytes on", bytes, size - header), {}};
  return {{},
          withHeader(*pixels, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                     file.subspan(static_cast<std::size_t>(header), static_cast<std::size_t>(bytes)))};
}

}  // namespace welkin::image
