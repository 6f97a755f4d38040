// SPDX-License-Identifier: Apache-2.0
#include "sky/image/image.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cfenv>
#include <limits>
#include <string_view>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/image/exr_read.h"
#include "sky/image/image_header.h"
#include "sky/image/image_module.h"

namespace welkin::image {
namespace {

constexpr std::size_t kMagicBytes = 4;

constexpr std::string_view kOpenExr = "openexr";

/// OpenImageIO's name of the format that starts with these bytes. Empty if Welkin does not read it.
std::string_view formatOf(std::string_view start) {
  using namespace std::string_view_literals;
  struct Magic {
    std::string_view bytes;
    const char* format;
  };
  static constexpr std::array<Magic, 13> kMagic = {{{"\x89PNG"sv, "png"},
                                                    {"\x76\x2f\x31\x01"sv, kOpenExr.data()},
                                                    {"II*\0"sv, "tiff"},
                                                    {"MM\0*"sv, "tiff"},
                                                    {"II+\0"sv, "tiff"},
                                                    {"MM\0+"sv, "tiff"},
                                                    {"\xff\xd8\xff"sv, "jpeg"},
                                                    {"#?"sv, "hdr"},
                                                    {"P2"sv, "pnm"},
                                                    {"P3"sv, "pnm"},
                                                    {"P5"sv, "pnm"},
                                                    {"P6"sv, "pnm"},
                                                    {"PF"sv, "pnm"}}};
  for (const Magic& magic : kMagic)
    if (start.starts_with(magic.bytes)) return magic.format;
  return {};
}

/// Throws for the first value that is not finite, or is below 0 where that is not allowed.
void requireValues(const std::filesystem::path& path, const Image& image, const ImageLimits& limits) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const float least = limits.negative ? -kLargest : 0.0F;
  const auto found =
      std::find_if_not(image.rgb.begin(), image.rgb.end(), [least](float v) { return v >= least && v <= kLargest; });
  if (found == image.rgb.end()) return;
  const auto i = found - image.rgb.begin();
  throw base::Error(
      base::ExitStatus::content,
      fmt::format("{}: {} at column {}, row {} from the top, channel {}; finite values{} are allowed", path.string(),
                  *found, i / 3 % image.width, i / 3 / image.width, i % 3, limits.negative ? "" : " from 0"));
}

}  // namespace

const ImageModule& imageModule() {
  static const ImageModule* const kModule = [] {
    std::fenv_t arithmetic;  // libraries built with -ffast-math change it when they are loaded
    std::fegetenv(&arithmetic);
    void* library = dlopen(WELKIN_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL);  // never closed: images may outlive any scope
    std::fesetenv(&arithmetic);
    if (library == nullptr)
      throw base::Error(base::ExitStatus::file, fmt::format("cannot load what reads images: {}", dlerror()));
    const auto entry = reinterpret_cast<const ImageModule* (*)()>(dlsym(library, kImageModuleEntry));
    if (entry == nullptr)
      throw base::Error(base::ExitStatus::file, fmt::format("{}: {}", WELKIN_IMAGE_MODULE, dlerror()));
    return entry();
  }();
  return *kModule;
}

Image readImage(const std::filesystem::path& path, const ImageLimits& limits) {
  // A missing or unreadable file is the system's error, not the image's.
  const auto start = base::readStart(path, kMagicBytes);
  const std::string_view format = formatOf({reinterpret_cast<const char*>(start.data()), start.size()});
  if (format.empty())
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{}: not an image that can be read: PNG, OpenEXR, TIFF, JPEG, Radiance HDR and PNM are",
                    path.string()));
  if (const auto why = whyHeaderUnusable(path, format, limits.largest_side))
    throw base::Error(base::ExitStatus::content, fmt::format("{}: damaged or cut: {}", path.string(), *why));
  const Image image = format == kOpenExr ? readExr(path, limits) : imageModule().read(path, format.data(), limits);
  requireValues(path, image, limits);
  return image;
}

std::vector<std::byte> encodePng(int width, int height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  return imageModule().encode_png(width, height, 8, rgb.data());
}

std::vector<std::byte> encodePng(int width, int height, std::span<const std::uint16_t> rgb) {
  assert(rgb.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  return imageModule().encode_png(width, height, 16, rgb.data());
}

void drawCaption(int width, int height, std::span<std::uint8_t> rgb, const Caption& caption) {
  assert(rgb.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  imageModule().draw_caption(width, height, rgb.data(), caption);
}

}  // namespace welkin::image
