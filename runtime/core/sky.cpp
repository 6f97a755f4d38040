// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that opens, closes and describes a sky, and hands out the file's content.
#include "core/sky.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "core/floats.h"
#include "format/cubemap_format.h"

namespace welkin::core {

WelkinResult fail(WelkinMessage* message, WelkinResult code, const char* format, ...) {
  if (message != nullptr) {
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(message->text, sizeof message->text, format, arguments);
    va_end(arguments);
  }
  return code;
}

namespace {

/// Decodes the numbers of a gradient that the file does not hold as floats. False when memory runs out.
bool decodeGradient(const format::Gradient& gradient, std::unique_ptr<float[]>& rgb) {
  const auto texels = spanOf(gradient.rgb9e5());
  if (texels.empty()) return true;
  rgb.reset(new (std::nothrow) float[3 * texels.size()]);
  if (rgb == nullptr) return false;
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
  opened.cubemap_time_h.reset(new (std::nothrow) double[opened.cubemap_count]);
  if (opened.cubemap_time_h == nullptr) return false;
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
  if (!listCubemaps(s, opened) || !decodeGradient(*s.gradient_sun(), opened.gradient_sun) ||
      !decodeGradient(*s.gradient_anti(), opened.gradient_anti))
    return fail(message, WELKIN_ERROR_MEMORY, "out of memory");
  *sky = new (std::nothrow) WelkinSky(std::move(opened));
  return *sky != nullptr ? WELKIN_OK : fail(message, WELKIN_ERROR_MEMORY, "out of memory");
}

/// Opens the sky in `bytes`. If they come from a file, `opened` holds the file's memory map.
WelkinResult openBytes(std::span<const std::byte> bytes, WelkinSky&& opened, WelkinSky** sky, WelkinMessage* message) {
  using format::Refusal;
  const format::Opened container = format::openContainer(bytes);
  const auto expected = static_cast<unsigned long long>(container.expected_size);
  switch (container.refusal) {
    case Refusal::none: {
      const WelkinResult result = checkContent(*container.file, bytes.size(), message);
      return result == WELKIN_OK ? keep(*container.file, std::move(opened), sky, message) : result;
    }
    case Refusal::misaligned:
      return fail(message, WELKIN_ERROR_ARGUMENT, "the bytes start at %p; they must be aligned to %zu",
                  static_cast<const void*>(bytes.data()), format::kAlignment);
    case Refusal::foreign:
      return fail(message, WELKIN_ERROR_FOREIGN, "not a .welkin file (it does not start with the .welkin signature)");
    case Refusal::version:
      return fail(message, WELKIN_ERROR_VERSION, "format version %u; this library reads version %u: bake again",
                  container.found_version, format::kVersion);
    case Refusal::truncated:
      return fail(message, WELKIN_ERROR_TRUNCATED, "%zu bytes; the header asks for %s%llu", bytes.size(),
                  bytes.size() < sizeof(format::Header) ? "at least " : "", expected);
    case Refusal::checksum:
      return fail(message, WELKIN_ERROR_CHECKSUM, "damaged: the checksum of its %zu bytes does not match",
                  bytes.size());
    case Refusal::structure:
      break;
  }
  return fail(message, WELKIN_ERROR_CONTENT, "damaged: an offset or length of its tables is out of bounds");
}

}  // namespace
}  // namespace welkin::core

using welkin::core::fail;
using welkin::core::spanOf;
using welkin::core::toFloat;

const char* welkin_result_string(WelkinResult result) {
  switch (result) {
    case WELKIN_OK:
      return "ok";
    case WELKIN_ERROR_ARGUMENT:
      return "invalid argument";
    case WELKIN_ERROR_FILE:
      return "cannot read the file";
    case WELKIN_ERROR_FOREIGN:
      return "not a .welkin file";
    case WELKIN_ERROR_VERSION:
      return "another format version";
    case WELKIN_ERROR_TRUNCATED:
      return "wrong size";
    case WELKIN_ERROR_CHECKSUM:
      return "damaged";
    case WELKIN_ERROR_CONTENT:
      return "invalid content";
    case WELKIN_ERROR_MEMORY:
      return "out of memory";
    case WELKIN_ERROR_DEVICE:
      return "device error";
  }
  return "unknown result";
}

WelkinResult welkin_sky_open_file(const char* path, WelkinSky** sky, WelkinMessage* message) {
  if (sky != nullptr) *sky = nullptr;
  if (path == nullptr || sky == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "a null pointer");
  WelkinSky opened;
  if (const int error = opened.map.open(path); error != 0)
    return fail(message, WELKIN_ERROR_FILE, "%s", std::strerror(error));
  return welkin::core::openBytes(opened.map.bytes(), std::move(opened), sky, message);
}

WelkinResult welkin_sky_open_memory(const void* data, size_t size, WelkinSky** sky, WelkinMessage* message) {
  if (sky != nullptr) *sky = nullptr;
  if (data == nullptr || sky == nullptr) return fail(message, WELKIN_ERROR_ARGUMENT, "a null pointer");
  return welkin::core::openBytes({static_cast<const std::byte*>(data), size}, WelkinSky(), sky, message);
}

void welkin_sky_close(WelkinSky* sky) {
  delete sky;
}

WelkinResult welkin_sky_info(const WelkinSky* sky, WelkinSkyInfo* info) {
  if (sky == nullptr || info == nullptr) return WELKIN_ERROR_ARGUMENT;
  const auto& s = *sky->file->sky();
  *info = {};
  info->bands = s.day()->bands();
  info->coefficient_count = info->bands * info->bands;
  info->key_count = s.day()->key_time_h()->size();
  info->mode_count = s.day()->modes() != nullptr ? s.day()->modes()->count() : 0;
  info->cubemap_count = s.cubemaps() != nullptr ? s.cubemaps()->size() : 0;
  info->cubemap_size = info->cubemap_count != 0 ? s.cubemap_size() : 0;
  info->cubemap_format = static_cast<WelkinCubemapFormat>(s.cubemap_format());
  info->has_moon = s.moon() != nullptr ? 1 : 0;
  info->luminance_unit = toFloat(s.luminance_unit());
  info->ground_albedo[0] = s.ground_albedo()->r();
  info->ground_albedo[1] = s.ground_albedo()->g();
  info->ground_albedo[2] = s.ground_albedo()->b();
  return WELKIN_OK;
}

WelkinResult welkin_sky_luminance(const WelkinSky* sky, WelkinLuminance* luminance) {
  if (sky == nullptr || luminance == nullptr) return WELKIN_ERROR_ARGUMENT;
  const auto& l = *sky->file->sky()->luminance();
  *luminance = {toFloat(l.a()), toFloat(l.b()), toFloat(l.c()),      toFloat(l.d()),
                toFloat(l.e()), toFloat(l.k()), l.normalise_to_sun()};
  return WELKIN_OK;
}

WelkinResult welkin_sky_gradients(const WelkinSky* sky, WelkinGradients* gradients) {
  if (sky == nullptr || gradients == nullptr) return WELKIN_ERROR_ARGUMENT;
  const auto& s = *sky->file->sky();
  const auto borrow = [](const welkin::format::Gradient& g, const float* decoded) {
    return WelkinGradient{g.width(), g.height(), decoded != nullptr ? decoded : g.rgb()->data()};
  };
  *gradients = {borrow(*s.gradient_sun(), sky->gradient_sun.get()),
                borrow(*s.gradient_anti(), sky->gradient_anti.get()), toFloat(s.gradient_delta())};
  return WELKIN_OK;
}

WelkinResult welkin_sky_cubemap(const WelkinSky* sky, uint32_t index, WelkinCubemap* cubemap) {
  if (sky == nullptr || cubemap == nullptr) return WELKIN_ERROR_ARGUMENT;
  const auto& s = *sky->file->sky();
  if (s.cubemaps() == nullptr || index >= s.cubemaps()->size()) return WELKIN_ERROR_ARGUMENT;
  const auto& c = *s.cubemaps()->Get(index);
  *cubemap = {c.time_h(), s.cubemap_size(), static_cast<WelkinCubemapFormat>(s.cubemap_format()), c.texels()->data(),
              c.texels()->size()};
  return WELKIN_OK;
}

WelkinResult welkin_sky_stars(const WelkinSky* sky, WelkinStars* stars) {
  if (sky == nullptr || stars == nullptr) return WELKIN_ERROR_ARGUMENT;
  *stars = {};
  if (const auto* s = sky->file->sky()->stars(); s != nullptr)
    *stars = {s->width(),
              s->height(),
              s->rgba8()->data(),
              toFloat(s->intensity()),
              toFloat(s->latitude_rad()),
              toFloat(s->north_offset_rad()),
              s->midnight_h()};
  return WELKIN_OK;
}

WelkinResult welkin_sky_modes(const WelkinSky* sky, WelkinModes* modes) {
  if (sky == nullptr || modes == nullptr) return WELKIN_ERROR_ARGUMENT;
  *modes = {};
  if (const auto* m = sky->file->sky()->day()->modes(); m != nullptr)
    *modes = {m->count(), m->columns(), m->rows(), m->texels()->data()};
  return WELKIN_OK;
}

WelkinResult welkin_sky_certificate(const WelkinSky* sky, WelkinCertificate* certificate) {
  if (sky == nullptr || certificate == nullptr) return WELKIN_ERROR_ARGUMENT;
  *certificate = {};
  if (const auto* c = sky->file->sky()->certificate(); c != nullptr)
    *certificate = {static_cast<WelkinCertificateMethod>(c->method()),
                    c->max_error(),
                    c->time_h(),
                    {c->normal()->x(), c->normal()->y(), c->normal()->z()},
                    c->channel(),
                    c->mean_error(),
                    c->quadrature(),
                    c->truncation(),
                    c->time(),
                    c->encoding(),
                    c->cubemap_error(),
                    c->cubemap_time_h(),
                    c->cubemap_resolution(),
                    c->cubemap_blend(),
                    c->cubemap_encoding(),
                    c->dome_error()};
  return WELKIN_OK;
}

WelkinResult welkin_sky_key_time(const WelkinSky* sky, uint32_t index, double* time_h) {
  if (sky == nullptr || time_h == nullptr) return WELKIN_ERROR_ARGUMENT;
  const auto keys = spanOf(sky->file->sky()->day()->key_time_h());
  if (index >= keys.size()) return WELKIN_ERROR_ARGUMENT;
  *time_h = keys[index];
  return WELKIN_OK;
}

WelkinResult welkin_sky_settings(const WelkinSky* sky, const char** json) {
  if (sky == nullptr || json == nullptr) return WELKIN_ERROR_ARGUMENT;
  *json = sky->file->settings()->c_str();
  return WELKIN_OK;
}
