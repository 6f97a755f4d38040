// SPDX-License-Identifier: Apache-2.0
#include "forge.h"

namespace welkin::tests {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

Offset<format::Curve> build(FlatBufferBuilder& b, const CurveParts& c) {
  return c.there ? format::CreateCurveDirect(b, c.components, &c.time_h, &c.value) : Offset<format::Curve>();
}

Offset<format::Light> build(FlatBufferBuilder& b, const LightParts& l) {
  if (!l.there) return {};
  const auto path = l.has_path ? format::CreateLightPathDirect(b, l.latitude, l.declination, l.transit, l.north,
                                                               &l.time_h, &l.azimuth, &l.elevation)
                               : Offset<format::LightPath>();
  const auto illuminance = build(b, l.illuminance);
  const auto colour = build(b, l.colour);
  return format::CreateLight(b, path, illuminance, colour, l.disc);
}

Offset<format::Gradient> build(FlatBufferBuilder& b, const GradientParts& g) {
  return g.there ? format::CreateGradientDirect(b, g.width, g.height, g.rgb.empty() ? nullptr : &g.rgb,
                                                g.rgb9e5.empty() ? nullptr : &g.rgb9e5)
                 : Offset<format::Gradient>();
}

}  // namespace

DayParts withEncoding(std::uint8_t encoding) {
  DayParts day;
  day.encoding = encoding;
  const std::size_t numbers = std::size_t{2} * day.rows * day.channels;
  day.numbers.assign(numbers * (encoding == 3 ? 1 : 2), 0x31);
  day.key_scale = {1.0F, 2.0F};
  if (encoding >= 2) day.row_scale.assign(numbers / 2, 1e-3F);
  return day;
}

DayParts withModes(std::uint8_t count) {
  DayParts day;
  day.mode_count = count;
  day.mode_texels.assign(std::size_t{count} * day.mode_columns * day.mode_rows, 0x3800);
  day.mode_sh.assign(std::size_t{count} * 3, 0.25F);
  return day;
}

std::vector<std::uint8_t> payloadOf(const Parts& p) {
  FlatBufferBuilder b;
  std::vector<Offset<format::Cubemap>> cubemaps;
  Offset<flatbuffers::Vector<std::uint8_t>> texels;
  for (const double time : p.cubemap_time_h) {
    if (p.has_texels && (texels.IsNull() || !p.shares_texels)) {
      b.ForceVectorAlignment(p.cubemap.size() * 2, 1, 16);
      texels = b.CreateVector(reinterpret_cast<const std::uint8_t*>(p.cubemap.data()), p.cubemap.size() * 2);
    }
    cubemaps.push_back(format::CreateCubemap(b, time, texels));
  }
  const auto intensity = build(b, p.intensity);
  const auto saturation = build(b, p.saturation);
  const auto tint = build(b, p.tint);
  const auto sun = build(b, p.sun);
  const auto moon = build(b, p.moon);
  const auto gradient_sun = build(b, p.gradient_sun);
  const auto gradient_anti = build(b, p.gradient_anti);
  const DayParts& d = p.day;
  const auto modes = d.mode_count > 0 ? format::CreateModesDirect(b, d.mode_count, d.mode_columns, d.mode_rows,
                                                                  &d.mode_texels, &d.mode_sh)
                                      : Offset<format::Modes>();
  const auto day = d.there ? format::CreateDayDirect(b, d.bands, d.channels, &d.key_time_h, d.rows,
                                                     static_cast<format::Encoding>(d.encoding), &d.numbers,
                                                     &d.key_scale, &d.row_scale, modes)
                           : Offset<format::Day>();
  const double* m = p.model;
  const format::Luminance luminance(m[0], m[1], m[2], m[3], m[4], m[5], p.normalise);
  const auto sky = format::CreateSkyDirect(
      b, p.has_luminance ? &luminance : nullptr, p.unit, p.has_albedo ? &p.albedo : nullptr, intensity, saturation,
      tint, sun, moon, gradient_sun, gradient_anti, p.delta, day, p.cubemap_size, &cubemaps, 0, p.cubemap_format);
  format::FinishFileBuffer(b, format::CreateFileDirect(b, p.has_settings ? "{}" : nullptr, nullptr,
                                                       p.has_sky ? sky : Offset<format::Sky>()));
  return {b.GetBufferPointer(), b.GetBufferPointer() + b.GetSize()};
}

}  // namespace welkin::tests
