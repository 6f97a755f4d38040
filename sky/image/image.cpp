// SPDX-License-Identifier: Apache-2.0
#include "sky/image/image.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <string_view>
#include <thread>
#include <utility>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/module.h"
#include "sky/image/coded_image.h"
#include "sky/image/coded_picture.h"
#include "sky/image/exr_read.h"
#include "sky/image/image_header.h"
#include "sky/image/image_module.h"
#include "sky/image/orientation.h"
#include "sky/image/pnm.h"
#include "sky/image/radiance_hdr.h"
#include "sky/image/stored_picture.h"

namespace welkin::image {
namespace {

constexpr std::string_view kOpenExr = "openexr";

/// OpenImageIO's name of the format that starts with these bytes. Empty if Welkin does not read it.
std::string_view formatOf(std::string_view start) {
  using namespace std::string_view_literals;
  struct Magic {
    std::string_view bytes;
    const char* format;
  };
  static constexpr std::array<Magic, 14> kMagic = {{{"\x89PNG"sv, "png"},
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
                                                    {"PF"sv, "pnm"},
                                                    {"Pf"sv, "pnm"}}};
  for (const Magic& magic : kMagic)
    if (start.starts_with(magic.bytes)) return magic.format;
  return {};
}

/// A conversion of colours turns the rounding of halves, 2^-11 of a texel's largest value, into values below 0: up to
/// 2e-3 of it, by the sums of the elements of common matrices. They become 0.
void settleRounding(Image& image) {
  constexpr float kRounding = 2e-3F;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    float* const texel = image.rgb.data() + i;
    const float least = -kRounding * std::max({texel[0], texel[1], texel[2]});
    for (int c = 0; c < 3; ++c)
      if (texel[c] < 0.0F && texel[c] >= least) texel[c] = 0.0F;
  }
}

/// Throws for the first value that is not finite, or is below 0 where that is not allowed.
void requireValues(const std::string& name, const Image& image, const ImageLimits& limits) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const float least = limits.negative ? -kLargest : 0.0F;
  const auto found =
      std::find_if_not(image.rgb.begin(), image.rgb.end(), [least](float v) { return v >= least && v <= kLargest; });
  if (found == image.rgb.end()) return;
  const auto i = found - image.rgb.begin();
  throw base::Error(base::ExitStatus::content,
                    fmt::format("{}: {} at column {}, row {} from the top, channel {}{}; finite values{} are allowed",
                                name, *found, i / 3 % image.width, i / 3 / image.width, i % 3,
                                image.converted ? ", converted to Rec. 709" : "", limits.negative ? "" : " from 0"));
}

/// Throws Error(content) for a header that must not be passed to the format's library.
void requireHeader(const std::string& name, std::span<const std::byte> bytes, std::string_view format,
                   const ImageLimits& limits) {
  if (const auto why = whyHeaderUnusable(bytes, format, limits.largest_side))
    throw base::Error(base::ExitStatus::content, fmt::format("{}: damaged or cut: {}", name, *why));
}

Image uprightCodes(StoredPicture picture) {
  turnUpright(orientationOfTag(picture.exif.orientation), picture.image);
  return std::move(picture.image);
}

Image codesOf(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const std::string_view format = formatOf({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (format == "hdr" || format == "pnm" || (format.empty() && !isTexture(name, bytes)))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: not a picture of codes that can be read: PNG, OpenEXR, TIFF, JPEG, WebP, BMP, "
                                  "Targa and some DDS are",
                                  name));
  if (!format.empty()) requireHeader(name, bytes, format, limits);
  if (format == kOpenExr) {
    Image image = readExr(name, bytes, limits, "");
    if (image.converted)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: chromaticities other than Rec. 709; codes have no colour", name));
    return image;
  }
  if (format == "tiff") return uprightCodes(imageModule().read_tiff(name, bytes, limits));
  if (!format.empty()) return uprightCodes(readCodedPicture(name, format, bytes, limits));
  const CodedImage coded = decodeImage(name, bytes, limits);
  Image image;
  image.width = coded.width;
  image.height = coded.height;
  image.rgb.reserve(coded.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < coded.rgba.size(); ++i)
    if (i % 4 != 3) image.rgb.push_back(static_cast<float>(coded.rgba[i]) / 255.0F);
  return image;
}

/// Throws Error(file) where there is no room for the module: its 260 libraries abort, crash or hang when they run out
/// of memory while they are loaded. They took 430 MB of addresses on two processors, and make a thread for each.
void requireRoomForModule() {
  const std::size_t room_mib = 432 + 8 * std::size_t{std::thread::hardware_concurrency()};
  const std::size_t bytes = room_mib << 20;
  void* room = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED)
    throw base::Error(base::ExitStatus::file,
                      fmt::format("out of memory: reading images takes {} MiB of addresses", room_mib));
  munmap(room, bytes);
}

}  // namespace

const ImageModule& imageModule() {
  static const ImageModule* const kModule = [] {
    requireRoomForModule();
    void* entry = base::loadModule(WELKIN_IMAGE_MODULE, kImageModuleEntry, "the reader of images");
    return reinterpret_cast<const ImageModule* (*)()>(entry)();
  }();
  return *kModule;
}

Image readImage(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits,
                const std::string& layer) {
  const std::string_view format = formatOf({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (format.empty())
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{}: not an image that can be read: PNG, OpenEXR, TIFF, JPEG, Radiance HDR and PNM are", name));
  requireHeader(name, bytes, format, limits);
  if (!layer.empty() && format != kOpenExr)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: no layer '{}': only OpenEXR has layers", name, layer));
  const auto read = [&] {
    if (format == kOpenExr) return readExr(name, bytes, limits, layer);
    if (format == "hdr") return readRadiance(name, bytes, limits);
    if (format == "pnm") return readPnm(name, bytes, limits);
    if (format == "tiff") return decoded(name, imageModule().read_tiff(name, bytes, limits), limits.linear_codes);
    return decoded(name, readCodedPicture(name, format, bytes, limits), limits.linear_codes);
  };
  Image image = read();
  if (image.converted && !limits.negative) settleRounding(image);
  requireValues(name, image, limits);
  return image;
}

Image readImage(const std::filesystem::path& path, const ImageLimits& limits, const std::string& layer) {
  return readImage(path.string(), base::readFile(path), limits, layer);
}

Image readCodes(const std::filesystem::path& path, const ImageLimits& limits) {
  const std::string name = path.string();
  Image image = codesOf(name, base::readFile(path), limits);
  requireValues(name, image, limits);
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
