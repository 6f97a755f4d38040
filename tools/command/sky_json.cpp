// SPDX-License-Identifier: Apache-2.0
#include "command/sky_json.h"

#include <fmt/format.h>

#include "command/arguments.h"
#include "format/cubemap_format.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"

namespace welkin::command {
namespace {

using Json = nlohmann::ordered_json;

const char* formatName(WelkinCubemapFormat format) {
  return format::nameOf(static_cast<format::CubemapFormat>(format));
}

Json keyJson(const Sky& sky, std::uint32_t index) {
  double time_h = 0.0;
  welkin_sky_key_time(sky.get(), index, &time_h);
  WelkinSkySample s{};
  sky.sample(time_h, s);
  Json key = {{"time_h", time_h}, {"sun", lightJson(s.sun)}};
  if (sky.info().has_moon != 0) key["moon"] = lightJson(s.moon);
  key["intensity"] = double{s.intensity};
  key["ambient_saturation"] = double{s.ambient_saturation};
  key["radiance_sh"] = coefficientsJson(s.radiance_sh, s.coefficient_count);
  key["ambient_sh"] = coefficientsJson(s.ambient_sh, s.coefficient_count);
  key["ground_radiance"] = vectorJson(s.ground_radiance);
  key["polarising_tint"] = vectorJson(s.polarising_tint);
  return key;
}

Json modesJson(const Sky& sky) {
  WelkinModes m{};
  welkin_sky_modes(sky.get(), &m);
  return {{"count", m.count}, {"columns", m.columns}, {"rows", m.rows}, {"family", fmt::format("{:016x}", m.family)}};
}

/// The certificate; null if nothing was measured.
Json certificateJson(const Sky& sky) {
  WelkinCertificate c{};
  welkin_sky_certificate(sky.get(), &c);
  if (c.method == WELKIN_CERTIFICATE_NONE) return nullptr;
  const char* channels[] = {"red", "green", "blue"};
  return {{"method", c.method == WELKIN_CERTIFICATE_FULL ? "full" : "fast"},
          {"max_error", c.max_error},
          {"time_h", c.time_h},
          {"normal", {c.normal[0], c.normal[1], c.normal[2]}},
          {"channel", channels[c.channel]},
          {"mean_error", c.mean_error},
          {"parts",
           {{"quadrature", c.quadrature}, {"truncation", c.truncation}, {"time", c.time}, {"encoding", c.encoding}}},
          {"cubemaps",
           {{"max_error", c.cubemap_error},
            {"time_h", c.cubemap_time_h},
            {"parts",
             {{"resolution", c.cubemap_resolution}, {"time", c.cubemap_blend}, {"encoding", c.cubemap_encoding}}}}},
          {"dome", {{"max_error", c.dome_error}}},
          {"blends", {{"max_error", c.blend_error}, {"time_h", c.blend_time_h}}}};
}

}  // namespace

Json settingsJson(const std::string& text) {
  auto settings = base::parseJson(text);
  if (!settings)
    throw base::Error(base::ExitStatus::content, "invalid content: settings are not JSON; bake the file again");
  return std::move(*settings);
}

Json skyJson(const Sky& sky) {
  const WelkinSkyInfo info = sky.info();
  WelkinLuminance l{};
  welkin_sky_luminance(sky.get(), &l);
  WelkinGradients g{};
  welkin_sky_gradients(sky.get(), &g);
  const char* settings = "";
  welkin_sky_settings(sky.get(), &settings);
  Json keys = Json::array();
  for (std::uint32_t i = 0; i < info.key_count; ++i) keys.push_back(keyJson(sky, i));
  Json cubemaps = Json::array();
  for (std::uint32_t i = 0; i < info.cubemap_count; ++i) {
    WelkinCubemap c{};
    welkin_sky_cubemap(sky.get(), i, &c);
    cubemaps.push_back({{"time_h", c.time_h}, {"size", c.size}, {"format", formatName(c.format)}, {"bytes", c.bytes}});
  }
  return {{"sky",
           {{"bands", info.bands},
            {"luminance",
             {{"a", double{l.a}},
              {"b", double{l.b}},
              {"c", double{l.c}},
              {"d", double{l.d}},
              {"e", double{l.e}},
              {"k", double{l.k}},
              {"normalise", l.normalise_to_sun != 0 ? "sun" : "zenith"}}},
            {"luminance_unit", double{info.luminance_unit}},
            {"ground_albedo", vectorJson(info.ground_albedo)},
            {"gradient_sun", {{"width", g.sun.width}, {"height", g.sun.height}}},
            {"gradient_anti", {{"width", g.anti.width}, {"height", g.anti.height}}},
            {"modes", modesJson(sky)},
            {"cubemaps", cubemaps},
            {"keys", keys},
            {"certificate", certificateJson(sky)}}},
          {"settings", settingsJson(settings)}};
}

}  // namespace welkin::command
