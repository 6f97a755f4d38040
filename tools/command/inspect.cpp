// SPDX-License-Identifier: Apache-2.0
// welkin inspect: prints everything in a .welkin file.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <welkin/welkin.hpp>

#include "baked/welkin_file.h"
#include "command/arguments.h"
#include "command/certificate_text.h"
#include "command/commands.h"
#include "command/sector_json.h"
#include "command/sky_json.h"
#include "format/cubemap_format.h"
#include "probes/build/certify_bake.h"
#include "probes/build/level_files.h"
#include "probes/contact/contact_file.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

using Json = nlohmann::ordered_json;

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

void printSurfaces(const Json& surfaces) {
  fmt::print("{}\n", surfacesText(surfaces));
  for (const std::string& message : build::worseThanNothing(surfaces)) fmt::print("{}\n", message);
}

/// What contact.json states beside an index; {"unused": why} for factors of another bake and files that are none.
std::optional<Json> contactJson(const std::filesystem::path& index) {
  try {
    return contact::readContactError(index.parent_path(), base::hashOf(base::readFile(index)));
  } catch (const base::Error& e) {
    Json unused = Json::object();
    unused["unused"] = e.what();
    return unused;
  }
}

void printContact(const Json& contact) {
  if (contact.contains("unused")) {
    fmt::print("no contact factors: {}\n", base::oneLine(contact["unused"].get<std::string>()));
    return;
  }
  const Json& e = contact["error"];
  fmt::print("contact factors of {} vertices: surfaces within {:.1f} +- {:.1f} % with them, {:.1f} % without\n",
             contact["vertices"].get<std::size_t>(), 100.0 * e["contact"].get<double>(),
             100.0 * e["interval"].get<double>(), 100.0 * e["probes"].get<double>());
}

/// The index, with the errors that its folder's files state of the same bake.
Json levelJson(const std::filesystem::path& path) {
  const sectors::LevelIndex index = build::readIndex(path);
  Json json = indexJson(index);
  if (const auto contact = contactJson(path)) json["level"]["contact"] = *contact;
  if (const auto surfaces = build::certificateIn(path.parent_path(), index)) json["level"]["surfaces"] = *surfaces;
  return json;
}

void inspectLevel(const std::string& path, bool as_json) {
  if (as_json) {
    fmt::print("{}\n", levelJson(path).dump(2));
    return;
  }
  const sectors::LevelIndex index = build::readIndex(path);
  fmt::print("{}: level, {} sectors\n", path, index.sector.size());
  for (const sectors::SectorEntry& s : index.sector)
    fmt::print("{:>9} {:4} probes {:8} bytes\n", nameOf(s.id), s.probes, s.bytes);
  if (const auto surfaces = build::certificateIn(std::filesystem::path(path).parent_path(), index))
    printSurfaces(*surfaces);
  if (const auto contact = contactJson(path)) printContact(*contact);
}

void inspect(const std::string& path, bool as_json) {
  const std::string file = baked::skyFileOf(path);
  const format::Kind kind = baked::kindOfFile(file);
  if (kind == format::Kind::sector) return inspectSector(file, as_json);
  if (kind == format::Kind::level) return inspectLevel(file, as_json);
  const Sky sky = baked::openSky(file);
  if (as_json) {
    Json json = skyJson(sky);
    if (build::isLevelFolder(path)) json["level"] = levelJson(build::indexPath(path))["level"];
    fmt::print("{}\n", json.dump(2));
    return;
  }
  if (build::isLevelFolder(path)) inspectLevel(build::indexPath(path).string(), false);
  const WelkinSkyInfo info = sky.info();
  fmt::print("{}: sky, {} keys x {} bands{}, {} cubemaps of {}{}{}, {}moon\n", file, info.key_count, info.bands,
             info.mode_count > 0 ? fmt::format(", {} modes", info.mode_count) : "", info.cubemap_count,
             info.cubemap_size, info.cubemap_count > 0 ? " " : "",
             info.cubemap_count > 0 ? format::nameOf(static_cast<format::CubemapFormat>(info.cubemap_format)) : "",
             info.has_moon != 0 ? "" : "no ");
  WelkinCertificate c{};
  welkin_sky_certificate(sky.get(), &c);
  if (c.method != WELKIN_CERTIFICATE_NONE)
    fmt::print(
        "irradiance within {:.3g} %, mean {:.3g} %{}{}\n", 100.0 * c.max_error, 100.0 * c.mean_error,
        c.blend_error > 0.0 ? fmt::format("; blends within its family within {:.3g} %", 100.0 * c.blend_error) : "",
        c.cubemap_error > 0.0 ? fmt::format("; cubemaps within {:.3g} %", 100.0 * c.cubemap_error) : "");
  fmt::print("{:>7} {:>8} {:>9} {:>10} {:>10}  {}\n", "time_h", "sun az", "elevation", "sun illum.", "intensity",
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
