// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that describes a sky and hands out the file's content.
#include "core/sky.h"

#include "core/arguments.h"
#include "core/floats.h"

namespace welkin::core {
namespace {

template <typename Struct>
WelkinResult checkGetter(const char* function, const WelkinSky* sky, const char* name, const Struct* out) {
  if (const auto r = nonNull(function, {{"sky", sky}})) return r;
  return sized(function, name, out);
}

}  // namespace
}  // namespace welkin::core

using namespace welkin::core;

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
    case WELKIN_ERROR_KIND:
      return "another kind of .welkin file";
  }
  return "unknown result";
}

WelkinResult welkin_sky_info(const WelkinSky* sky, WelkinSkyInfo* info) {
  if (const auto r = checkGetter(__func__, sky, "info", info)) return r;
  const auto& s = *sky->file->sky();
  WelkinSkyInfo out{};
  out.bands = s.day()->bands();
  out.coefficient_count = out.bands * out.bands;
  out.key_count = s.day()->key_time_h()->size();
  out.mode_count = s.day()->modes() != nullptr ? s.day()->modes()->count() : 0;
  out.cubemap_count = s.cubemaps() != nullptr ? s.cubemaps()->size() : 0;
  out.cubemap_size = out.cubemap_count != 0 ? s.cubemap_size() : 0;
  out.cubemap_format = static_cast<WelkinCubemapFormat>(s.cubemap_format());
  out.has_moon = s.moon() != nullptr ? 1 : 0;
  out.luminance_unit = toFloat(s.luminance_unit());
  out.ground_albedo[0] = s.ground_albedo()->r();
  out.ground_albedo[1] = s.ground_albedo()->g();
  out.ground_albedo[2] = s.ground_albedo()->b();
  give(out, info);
  return WELKIN_OK;
}

WelkinResult welkin_sky_luminance(const WelkinSky* sky, WelkinLuminance* luminance) {
  if (const auto r = checkGetter(__func__, sky, "luminance", luminance)) return r;
  const auto& l = *sky->file->sky()->luminance();
  const WelkinLuminance out{sizeof out,     toFloat(l.a()), toFloat(l.b()), toFloat(l.c()),
                            toFloat(l.d()), toFloat(l.e()), toFloat(l.k()), l.normalise_to_sun()};
  give(out, luminance);
  return WELKIN_OK;
}

WelkinResult welkin_sky_gradients(const WelkinSky* sky, WelkinGradients* gradients) {
  if (const auto r = checkGetter(__func__, sky, "gradients", gradients)) return r;
  const auto& s = *sky->file->sky();
  const auto borrow = [](const welkin::format::Gradient& g, const float* decoded) {
    return WelkinGradient{g.width(), g.height(), decoded != nullptr ? decoded : g.rgb()->data()};
  };
  WelkinGradients out{};
  out.sun = borrow(*s.gradient_sun(), sky->gradient_sun.get());
  out.anti = borrow(*s.gradient_anti(), sky->gradient_anti.get());
  out.delta = toFloat(s.gradient_delta());
  give(out, gradients);
  return WELKIN_OK;
}

WelkinResult welkin_sky_cubemap(const WelkinSky* sky, uint32_t index, WelkinCubemap* cubemap) {
  if (const auto r = checkGetter(__func__, sky, "cubemap", cubemap)) return r;
  const auto& s = *sky->file->sky();
  const std::uint32_t count = s.cubemaps() != nullptr ? s.cubemaps()->size() : 0;
  if (index >= count) return refuse(__func__, "index is %u, the sky has %u cubemaps", index, count);
  const auto& c = *s.cubemaps()->Get(index);
  WelkinCubemap out{};
  out.size = s.cubemap_size();
  out.time_h = c.time_h();
  out.format = static_cast<WelkinCubemapFormat>(s.cubemap_format());
  out.texels = c.texels()->data();
  out.bytes = c.texels()->size();
  give(out, cubemap);
  return WELKIN_OK;
}

WelkinResult welkin_sky_stars(const WelkinSky* sky, WelkinStars* stars) {
  if (const auto r = checkGetter(__func__, sky, "stars", stars)) return r;
  WelkinStars out{};
  if (const auto* s = sky->file->sky()->stars(); s != nullptr)
    out = {sizeof out,
           s->width(),
           s->height(),
           s->rgba8()->data(),
           toFloat(s->intensity()),
           toFloat(s->latitude_rad()),
           toFloat(s->north_offset_rad()),
           s->midnight_h()};
  give(out, stars);
  return WELKIN_OK;
}

WelkinResult welkin_sky_modes(const WelkinSky* sky, WelkinModes* modes) {
  if (const auto r = checkGetter(__func__, sky, "modes", modes)) return r;
  WelkinModes out{};
  if (const auto* m = sky->file->sky()->day()->modes(); m != nullptr)
    out = {sizeof out, m->count(), m->columns(), m->rows(), m->texels()->data(), sky->day.family()};
  give(out, modes);
  return WELKIN_OK;
}

WelkinResult welkin_sky_certificate(const WelkinSky* sky, WelkinCertificate* certificate) {
  if (const auto r = checkGetter(__func__, sky, "certificate", certificate)) return r;
  WelkinCertificate out{};
  if (const auto* c = sky->file->sky()->certificate(); c != nullptr)
    out = {sizeof out,
           static_cast<WelkinCertificateMethod>(c->method()),
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
           c->dome_error(),
           c->blend_error(),
           c->blend_time_h()};
  give(out, certificate);
  return WELKIN_OK;
}

WelkinResult welkin_sky_key_time(const WelkinSky* sky, uint32_t index, double* time_h) {
  if (const auto r = nonNull(__func__, {{"sky", sky}, {"time_h", time_h}})) return r;
  const auto keys = spanOf(sky->file->sky()->day()->key_time_h());
  if (index >= keys.size()) return refuse(__func__, "index is %u, the sky has %zu keys", index, keys.size());
  *time_h = keys[index];
  return WELKIN_OK;
}

WelkinResult welkin_sky_settings(const WelkinSky* sky, const char** json) {
  if (const auto r = nonNull(__func__, {{"sky", sky}, {"json", json}})) return r;
  *json = sky->file->settings()->c_str();
  return WELKIN_OK;
}
