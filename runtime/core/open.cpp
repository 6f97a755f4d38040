// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that opens and closes a sky, and tells the kind and version of files.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "core/arguments.h"
#include "core/floats.h"
#include "core/sky.h"
#include "format/cubemap_format.h"

namespace welkin::core {

namespace {

/// Decodes the numbers of a gradient that the file does not hold as floats. False when memory runs out.
bool decodeGradient(const format::Gradient& gradient, const HostMemory& memory, HostArray<float>& rgb) {
  const auto texels = spanOf(gradient.rgb9e5());
  if (texels.empty()) return true;
  if (!rgb.allocate(memory, 3 * texels.size())) return false;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    float texel[3];
    format::decodeTexel(format::CubemapFormat::rgb9e5, reinterpret_cast<const unsigned char*>(&texels[i]), texel);
    std::copy_n(texel, 3, rgb.get() + 3 * i);
  }
  return true;
}

/// Lists the hours of the cubemaps, which every sample searches. False when memory runs out.
bool listCubemaps(const format::Sky& sky, WelkinSky& opened) {
  if (sky.cubemaps() == nullptr || sky.cubemaps()->size() == 0) return true;
  opened.cubemap_count = sky.cubemaps()->size();
  if (!opened.cubemap_time_h.allocate(opened.source.memory, opened.cubemap_count)) return false;
  double* time_h = opened.cubemap_time_h.get();
  for (const auto* cubemap : *sky.cubemaps()) *time_h++ = cubemap->time_h();
  return true;
}

/// Completes `opened` from a file that checkContent has let pass, and moves it to *sky.
WelkinResult keep(const format::File& file, WelkinSky&& opened, WelkinSky** sky, WelkinMessage* message) {
  const auto& s = *file.sky();
  opened.file = &file;
  opened.intensity = Curve(*s.intensity());
  opened.ambient_saturation = Curve(*s.ambient_saturation());
  opened.polarising_tint = Curve(*s.polarising_tint());
  opened.sun = Light(*s.sun());
  if (s.moon() != nullptr) opened.moon = Light(*s.moon());
  opened.luminance = luminanceModel(*s.luminance());
  opened.normalise_to_sun = s.luminance()->normalise_to_sun() != 0;
  opened.constant_norm = f64::constantNorm(opened.luminance, opened.normalise_to_sun);
  const auto& albedo = *s.ground_albedo();
  opened.albedo = {double{albedo.r()}, double{albedo.g()}, double{albedo.b()}};
  opened.day = Day(*s.day());
  const f64::ShBasis up = f64::shBasis({0.0, 1.0, 0.0});
  for (std::uint32_t i = 0; i < 25; ++i) opened.ground_sh[i] = f64::groundLobe(bandOf(i)) * up.v[i];
  void* room = nullptr;
  if (!listCubemaps(s, opened) || !decodeGradient(*s.gradient_sun(), opened.source.memory, opened.gradient_sun) ||
      !decodeGradient(*s.gradient_anti(), opened.source.memory, opened.gradient_anti) ||
      (room = opened.source.memory.allocate(sizeof(WelkinSky), alignof(WelkinSky))) == nullptr)
    return fail(message, WELKIN_ERROR_MEMORY, "out of memory");
  *sky = new (room) WelkinSky(std::move(opened));
  return WELKIN_OK;
}

/// Opens the sky that `info` names; `message` gets the reason without the path.
WelkinResult openFrom(const WelkinOpenInfo& info, WelkinSky** sky, WelkinMessage* message) {
  FileBytes source;
  if (const auto r = readBytes(info, source, message)) return r;
  const format::File* file = nullptr;
  if (const auto r = rootOf(source.bytes, format::Kind::sky, &file, message)) return r;
  if (const auto r = checkContent(*file, source.bytes.size(), message)) return r;
  WelkinSky opened;
  opened.source = std::move(source);
  return keep(*file, std::move(opened), sky, message);
}

/// Logs an opened sky and its stated error.
void logOpened(const WelkinLog& log, const WelkinOpenInfo& info, const WelkinSky& sky) {
  char text[256];
  const char* name = info.path != nullptr ? info.path : "a sky in memory";
  const auto* certificate = sky.file->sky()->certificate();
  if (certificate == nullptr) {
    std::snprintf(text, sizeof text, "%.160s: the error of this sky was not measured; bake with --certify fast", name);
    return log.write(log.user, WELKIN_LOG_WARNING, text);
  }
  std::snprintf(text, sizeof text, "%.160s: format version %u, irradiance within %.3g %%", name, format::kSkyVersion,
                100.0 * certificate->max_error());
  log.write(log.user, WELKIN_LOG_INFO, text);
}

WelkinResult open(const char* function, const WelkinOpenInfo& info, WelkinSky** sky, WelkinMessage* message) {
  if (sky != nullptr) *sky = nullptr;
  WelkinResult fault = nonNull(function, {{"sky", sky}});
  if (fault == WELKIN_OK) fault = checkOpenInfo(function, info);
  if (fault != WELKIN_OK) return fail(message, fault, "%s", welkin_argument_error());
  WelkinMessage reason{};
  const WelkinResult result = openFrom(info, sky, &reason);
  if (result == WELKIN_OK && info.log != nullptr) logOpened(*info.log, info, **sky);
  return endOpen(function, info, result, reason, message);
}

}  // namespace
}  // namespace welkin::core

using welkin::core::take;

uint32_t welkin_version(void) {
  return WELKIN_VERSION;
}

uint32_t welkin_format_version(void) {
  return welkin::format::kSkyVersion;
}

WelkinFileKind welkin_file_kind(const void* data, size_t size) {
  if (data == nullptr) return WELKIN_FILE_FOREIGN;
  const auto kind = welkin::format::kindOf({static_cast<const std::byte*>(data), size});
  return kind ? static_cast<WelkinFileKind>(WELKIN_FILE_SKY + static_cast<int>(*kind)) : WELKIN_FILE_FOREIGN;
}

WelkinResult welkin_sky_open(const WelkinOpenInfo* info, WelkinSky** sky, WelkinMessage* message) {
  if (sky != nullptr) *sky = nullptr;
  if (const auto r = welkin::core::sized(__func__, "info", info))
    return welkin::core::fail(message, r, "%s", welkin_argument_error());
  return welkin::core::open(__func__, take(*info), sky, message);
}

WelkinResult welkin_sky_open_file(const char* path, WelkinSky** sky, WelkinMessage* message) {
  WelkinOpenInfo info{};
  info.path = path;
  return welkin::core::open(__func__, info, sky, message);
}

WelkinResult welkin_sky_open_memory(const void* data, size_t size, WelkinSky** sky, WelkinMessage* message) {
  WelkinOpenInfo info{};
  info.data = data;
  info.size = size;
  return welkin::core::open(__func__, info, sky, message);
}

void welkin_sky_close(WelkinSky* sky) {
  if (sky == nullptr) return;
  const welkin::core::HostMemory memory = sky->source.memory;
  sky->~WelkinSky();
  memory.free(sky, sizeof(WelkinSky));
}
