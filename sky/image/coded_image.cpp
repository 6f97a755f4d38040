// SPDX-License-Identifier: Apache-2.0
#include "sky/image/coded_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "sky/base/error.h"
#include "sky/image/dds_header.h"
#include "sky/image/image_header.h"
#include "sky/image/image_module.h"
#include "sky/image/texel_decoder.h"

namespace welkin::image {
namespace {

/// OpenImageIO's name of the format, or "webp". Empty when the format is not supported.
const char* formatOf(const std::string& name, std::span<const std::byte> bytes) {
  using namespace std::string_view_literals;
  const std::string_view start(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (start.starts_with("\x89PNG"sv)) return "png";
  if (start.starts_with("\xff\xd8\xff"sv)) return "jpeg";
  if (start.starts_with("RIFF"sv) && start.substr(std::min<std::size_t>(8, start.size())).starts_with("WEBP"sv))
    return "webp";
  if (start.starts_with("BM"sv)) return "bmp";
  if (isDds(bytes)) return isReadableDds(bytes) ? "dds" : "";
  std::string end = name.substr(name.size() - std::min<std::size_t>(4, name.size()));
  std::transform(end.begin(), end.end(), end.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return end == ".tga" ? "targa" : "";
}

}  // namespace

bool isTexture(const std::string& name, std::span<const std::byte> bytes) {
  return formatOf(name, bytes)[0] != '\0';
}

CodedImage decodeImage(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  const std::string_view format = formatOf(name, bytes);
  if (format.empty())
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{}: not a texture that can be read: PNG, JPEG, WebP, BMP, Targa and some DDS are", name));
  if (const auto why = whyHeaderUnusable(bytes, format, limits.largest_side))
    throw base::Error(base::ExitStatus::content, fmt::format("{}: damaged or cut: {}", name, *why));
  if (format == "png" || format == "jpeg" || format == "webp") return decodeTexels(name, format, bytes, limits);
  return imageModule().decode(name, format.data(), bytes, limits);
}

}  // namespace welkin::image
