// SPDX-License-Identifier: Apache-2.0
// welkin inspect: everything in a .welkin file.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <welkin/welkin.hpp>

#include "command/arguments.h"
#include "command/commands.h"
#include "command/level_files.h"
#include "command/sector_json.h"
#include "command/welkin_file.h"
#include "format/cubemap_format.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"

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
  return {{"count", m.count}, {"columns", m.columns}, {"rows", m.rows}};
}

/// Null when nothing was measured.
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
          {"dome", {{"max_error", c.dome_error}}}};
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
          {"settings", Json::parse(settings, nullptr, false)}};
}

void inspectSector(const std::string& path, bool as_json) {
  const auto bytes = base::readFile(path);
  const sectors::SectorFile sector = sectors::decodeSector(bytes, path);
  if (as_json) {
    fmt::print("{}\n", sectorJson(sector, bytes.size()).dump(2));
    return;
  }
  fmt::print("{}: sector {}, {} probes x {} bytes, {} modes of the sun\n", path, nameOf(sector.id),
             sector.probes.probes(), sector.probes.bytesAProbe(), sector.probes.modes());
  const Json parts = bytesJson(sector, bytes.size());
  for (const auto& [name, count] : parts.items()) fmt::print("{:17} {:8} bytes\n", name, count.get<std::size_t>());
  fmt::print("sampling   within {:.3g} %, worst at probe {}\n", 100.0 * sector.error.sampling,
             sector.error.sampling_probe);
  if (!sector.room.empty()) fmt::print("rooms      {}, with probes of their own\n", sector.room.size());
  if (sector.unlit > 0) fmt::print("unlit      {} probes: no light of sky, sun, moon or emission\n", sector.unlit);
  if (!sector.local) return;
  const auto& local = *sector.local;
  fmt::print("local      {} virtual lights, {} transfers; {} dropped with {:.3g} % of the influence\n",
             local.encoded.position.size() / 3, local.thinning.kept, local.thinning.dropped,
             100.0 * local.thinning.lost);
  fmt::print("           within {:.3g} %, worst at probe {}; {} rays\n", 100.0 * local.sampling.error,
             local.sampling.probe, local.sampling.rays);
}

void inspectLevel(const std::string& path, bool as_json) {
  const sectors::LevelIndex index = readIndex(path);
  if (as_json) {
    fmt::print("{}\n", indexJson(index).dump(2));
    return;
  }
  fmt::print("{}: level, {} sectors\n", path, index.sector.size());
  for (const sectors::SectorEntry& s : index.sector)
    fmt::print("{:>9} {:4} probes {:8} bytes\n", nameOf(s.id), s.probes, s.bytes);
}

void inspect(const std::string& path, bool as_json) {
  const std::string file = skyFileOf(path);
  const Holds holds = whatHolds(file);
  if (holds == Holds::sector) return inspectSector(file, as_json);
  if (holds == Holds::level) return inspectLevel(file, as_json);
  const Sky sky = openSky(file);
  if (as_json) {
    Json json = skyJson(sky);
    if (isLevelFolder(path)) json["level"] = indexJson(readIndex(indexPath(path)))["level"];
    fmt::print("{}\n", json.dump(2));
    return;
  }
  if (isLevelFolder(path)) inspectLevel(indexPath(path).string(), false);
  const WelkinSkyInfo info = sky.info();
  fmt::print("{}: sky, {} keys x {} bands{}, {} cubemaps of {}{}{}, {}moon\n", file, info.key_count, info.bands,
             info.mode_count > 0 ? fmt::format(", {} modes", info.mode_count) : "", info.cubemap_count,
             info.cubemap_size, info.cubemap_count > 0 ? " " : "",
             info.cubemap_count > 0 ? formatName(info.cubemap_format) : "", info.has_moon != 0 ? "" : "no ");
  WelkinCertificate c{};
  welkin_sky_certificate(sky.get(), &c);
  if (c.method != WELKIN_CERTIFICATE_NONE)
    fmt::print("irradiance within {:.3g} %, mean {:.3g} %{}\n", 100.0 * c.max_error, 100.0 * c.mean_error,
               c.cubemap_error > 0.0 ? fmt::format("; cubemaps within {:.3g} %", 100.0 * c.cubemap_error) : "");
  fmt::print("{:>7} {:>8} {:>9} {:>10} {:>10}  {}\n", "time_h", "sun az", "elevation", "sun lux", "intensity",
             "ambient c0 (r, g, b)");
  for (std::uint32_t i = 0; i < info.key_count; ++i) {
    double time_h = 0.0;
    welkin_sky_key_time(sky.get(), i, &time_h);
    WelkinSkySample s{};
    sky.sample(time_h, s);
    fmt::print("{:7.3f} {:8.2f} {:9.2f} {:10.4g} {:10.4g}  {:.5g}, {:.5g}, {:.5g}\n", time_h,
               azimuthDegrees(s.sun.direction), elevationDegrees(s.sun.direction), s.sun.illuminance, s.intensity,
               s.ambient_sh[0][0], s.ambient_sh[0][1], s.ambient_sh[0][2]);
  }
}

}  // namespace

void addInspect(CLI::App& app) {
  auto file = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  auto* command = app.add_subcommand("inspect", "Show everything in a .welkin file");
  command->add_option("FILE", *file, "A .welkin file, or the folder of a bake")->required();
  command->add_flag("--json", *json, "Print JSON");
  command->callback([file, json] { inspect(*file, *json); });
}

}  // namespace welkin::command
