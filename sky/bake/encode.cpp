// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/encode.h"

namespace welkin::bake {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

Offset<format::Curve> encodeCurve(FlatBufferBuilder& b, const base::Curve& curve) {
  return format::CreateCurveDirect(b, static_cast<std::uint8_t>(curve.components), &curve.time_h, &curve.value);
}

Offset<format::Light> encodeLight(FlatBufferBuilder& b, const model::Light& light) {
  const auto path = encodePath(b, light.path);
  const auto illuminance = encodeCurve(b, light.illuminance);
  const auto colour = encodeCurve(b, light.colour);
  return format::CreateLight(b, path, illuminance, colour, light.disc_radius_rad);
}

Offset<format::Gradient> encodeGradient(FlatBufferBuilder& b, const model::Gradient& gradient,
                                        model::GradientFormat texel_format) {
  if (texel_format == model::GradientFormat::rgb9e5) {
    std::vector<std::uint32_t> texels(gradient.rgb.size() / 3);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const float rgb[3] = {gradient.rgb[3 * i], gradient.rgb[3 * i + 1], gradient.rgb[3 * i + 2]};
      format::encodeTexel(format::CubemapFormat::rgb9e5, rgb, reinterpret_cast<unsigned char*>(&texels[i]));
    }
    return format::CreateGradientDirect(b, static_cast<std::uint32_t>(gradient.width),
                                        static_cast<std::uint32_t>(gradient.height), nullptr, &texels);
  }
  return format::CreateGradientDirect(b, static_cast<std::uint32_t>(gradient.width),
                                      static_cast<std::uint32_t>(gradient.height), &gradient.rgb);
}

Offset<format::Stars> encodeStars(FlatBufferBuilder& b, const model::Stars& stars) {
  b.ForceVectorAlignment(stars.rgba.size(), 1, 16);
  const auto texels = b.CreateVector(stars.rgba);
  return format::CreateStars(b, static_cast<std::uint32_t>(stars.width), static_cast<std::uint32_t>(stars.height),
                             texels, stars.intensity, stars.latitude_rad, stars.north_offset_rad, stars.midnight_h);
}

Offset<format::Cubemap> encodeCubemap(FlatBufferBuilder& b, double time_h, const cubemap::Cubemap& cubemap) {
  b.ForceVectorAlignment(cubemap.texels.size(), 1, 16);
  const auto texels = b.CreateVector(cubemap.texels);
  return format::CreateCubemap(b, time_h, texels);
}

Offset<format::Day> encodeDay(FlatBufferBuilder& b, const table::DayTable& table, table::Encoding encoding) {
  const table::EncodedNumbers e = table::encodeNumbers(table, encoding);
  Offset<format::Modes> modes;
  if (table.modes)
    modes = format::CreateModesDirect(
        b, static_cast<std::uint8_t>(table.modes->count), static_cast<std::uint16_t>(table.modes->columns),
        static_cast<std::uint16_t>(table.modes->rows), &table.modes->texels, &table.modes->polar_sh);
  b.ForceVectorAlignment(e.numbers.size(), 1, 16);
  const auto numbers = b.CreateVector(e.numbers);
  const auto times = b.CreateVector(table.key_time_h);
  const auto key_scale = e.key_scale.empty() ? 0 : b.CreateVector(e.key_scale);
  const auto row_scale = e.row_scale.empty() ? 0 : b.CreateVector(e.row_scale);
  return format::CreateDay(b, static_cast<std::uint8_t>(table.bands), static_cast<std::uint8_t>(table.channels), times,
                           static_cast<std::uint8_t>(table.rows), encoding, numbers, key_scale, row_scale, modes);
}

Offset<format::Certificate> encodeCertificate(FlatBufferBuilder& b, const table::Certificate& c) {
  const format::Direction normal(c.normal.x, c.normal.y, c.normal.z);
  return format::CreateCertificate(b, static_cast<std::uint8_t>(c.method), c.max_error, c.time_h, &normal,
                                   static_cast<std::uint8_t>(c.channel), c.mean_error, c.parts.quadrature,
                                   c.parts.truncation, c.parts.time, c.parts.encoding, c.cubemaps.max_error,
                                   c.cubemaps.time_h, c.cubemaps.resolution, c.cubemaps.time, c.cubemaps.encoding,
                                   c.dome_error, c.blends.max_error, c.blends.time_h);
}

}  // namespace

Offset<format::LightPath> encodePath(FlatBufferBuilder& b, const model::LightPath& p) {
  return format::CreateLightPathDirect(b, p.latitude_rad, p.declination_rad, p.transit_h, p.north_offset_rad,
                                       &p.key_time_h, &p.key_azimuth_rad, &p.key_elevation_rad);
}

std::vector<std::byte> encodeSky(const SkyFile& file, const table::DayTable& table,
                                 const std::vector<cubemap::Cubemap>& cubemaps, table::Encoding encoding,
                                 const table::Certificate* certificate) {
  FlatBufferBuilder b(1 << 16);
  const model::Sky& s = file.sky;
  std::vector<Offset<format::Cubemap>> cubemap;
  for (std::size_t i = 0; i < cubemaps.size(); ++i)
    cubemap.push_back(encodeCubemap(b, file.bake.cubemap_time_h[i], cubemaps[i]));
  std::vector<Offset<format::Input>> input;
  for (const Input& i : file.inputs)
    input.push_back(format::CreateInputDirect(b, i.name.c_str(), i.xxh3_low, i.xxh3_high));

  const model::LuminanceModel& m = s.luminance;
  const format::Luminance luminance(m.a, m.b, m.c, m.d, m.e, m.k, s.normalise_to_sun ? 1 : 0);
  const format::Rgb albedo(static_cast<float>(s.ground_albedo.x), static_cast<float>(s.ground_albedo.y),
                           static_cast<float>(s.ground_albedo.z));
  const auto intensity = encodeCurve(b, s.intensity);
  const auto saturation = encodeCurve(b, s.ambient_saturation);
  const auto tint = encodeCurve(b, s.polarising_tint);
  const auto sun = encodeLight(b, s.sun);
  const auto moon = s.moon ? encodeLight(b, *s.moon) : Offset<format::Light>();
  const auto stars = s.stars ? encodeStars(b, *s.stars) : Offset<format::Stars>();
  const auto gradient_sun = encodeGradient(b, s.gradient_sun, file.bake.gradient_format);
  const auto gradient_anti = encodeGradient(b, s.gradient_anti, file.bake.gradient_format);
  const auto day = encodeDay(b, table, encoding);
  const auto certified = certificate != nullptr ? encodeCertificate(b, *certificate) : Offset<format::Certificate>();
  const auto sky = format::CreateSkyDirect(
      b, &luminance, s.luminance_unit, &albedo, intensity, saturation, tint, sun, moon, gradient_sun, gradient_anti,
      model::kGradientDelta, day, static_cast<std::uint32_t>(cubemaps.empty() ? 0 : file.bake.cubemap_size), &cubemap,
      stars, static_cast<std::uint8_t>(cubemaps.empty() ? format::CubemapFormat::rgba16f : cubemaps.front().format),
      certified);
  format::FinishFileBuffer(b, format::CreateFileDirect(b, file.settings.c_str(), &input, sky));
  return format::seal({b.GetBufferPointer(), b.GetSize()});
}

}  // namespace welkin::bake
