// SPDX-License-Identifier: Apache-2.0
#include "probes/build/certify_bake.h"

#include <fmt/format.h>

#include <algorithm>

#include "probes/build/level_files.h"
#include "probes/build/merged_report.h"
#include "probes/certify/level_certificate.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;

/// Version of the measurement; it grows when the same files get other numbers.
constexpr std::uint32_t kCertificateVersion = 2;
constexpr const char* kKey = "surfaces";

/// Points of a fast certificate. Its paths are half of the probes' own, within these limits.
constexpr std::size_t kFewestPoints = 24, kMostPoints = 256, kPointsOfFull = 1024;

/// What the certificate is of: the files, and how they were measured.
std::string subjectOf(const LevelBake& level, const sectors::LevelIndex& index, bake::Certify how) {
  base::Hasher hasher;
  hasher.add(kCertificateVersion);
  hasher.add(std::string_view(bake::nameOf(how)));
  hasher.add(level.geometryHash());
  if (index.sky_checksum) hasher.add(*index.sky_checksum);
  for (const sectors::SectorEntry& s : index.sector) hasher.add(s.checksum);
  return textOf(hasher.digest());
}

Json rmsJson(const certify::RmsError& e) {
  return {{"rms", e.rms}, {"interval", e.interval}};
}

Json partJson(const certify::PartError& e) {
  return {{"rms", e.rms}, {"interval", e.interval}, {"nothing", e.nothing}, {"worse_than_nothing", e.worse}};
}

Json errorsJson(const certify::ErrorsOf& e) {
  return {{"sky", partJson(e.sky)},    {"sun_bounce", partJson(e.sun_bounce)}, {"local", partJson(e.local)},
          {"total", rmsJson(e.total)}, {"nothing", rmsJson(e.nothing)},        {"without", e.without}};
}

Json placeJson(const f64::Number3& v) {
  return {v.x, v.y, v.z};
}

Json certificateJson(const certify::LevelCertificate& c) {
  Json hours = Json::array();
  for (const certify::HourErrors& h : c.hour)
    hours.push_back({{"time_h", h.time_h}, {"surface", errorsJson(h.surface)}, {"air", errorsJson(h.air)}});
  Json worst = Json::array();
  for (const certify::WorstPoint& w : c.worst)
    worst.push_back({{"position", placeJson(w.position)},
                     {"normal", placeJson(w.normal)},
                     {"time_h", w.time_h},
                     {"error", w.error}});
  return {{"points", {{"surface", c.surface_points}, {"air", c.air_points}}},
          {"surface", errorsJson(c.surface)},
          {"air", errorsJson(c.air)},
          {"hours", std::move(hours)},
          {"worst", std::move(worst)}};
}

/// The certificate of an earlier bake, if it is of the same subject.
std::optional<Json> earlier(const std::filesystem::path& folder, const std::string& subject) {
  const auto report = earlierReport(folder);
  if (!report || !report->contains(kKey)) return std::nullopt;
  const Json& found = (*report)[kKey];
  if (!found.is_object() || !found.contains("of") || found["of"] != subject) return std::nullopt;
  return found;
}

void warnOfWorse(const Json& certificate, Json& warnings) {
  for (const std::string& message : worseThanNothing(certificate))
    warnings.push_back({{"id", "worse-than-nothing"}, {"message", message}});
}

}  // namespace

certify::CertifySettings certifySettings(const LevelBake& level, std::size_t probes, bake::Certify how) {
  certify::CertifySettings settings;
  settings.bounces = level.bounces();
  settings.all_hours = how == bake::Certify::full;
  constexpr std::size_t kHours = 4;
  const std::size_t paths = probes * level.raysOfProbe() / 2;
  settings.surface_points =
      settings.all_hours ? kPointsOfFull : std::clamp(paths / (kHours * settings.paths), kFewestPoints, kMostPoints);
  settings.air_points = settings.surface_points / 2;
  return settings;
}

std::optional<Json> certificateIn(const std::filesystem::path& folder, const sectors::LevelIndex& index) {
  const auto report = earlierReport(folder);
  static const Json kForm = {{kKey, {{"surface", Json::object()}, {"air", Json::object()}}},
                             {"sectors", Json::array({{{"sector", ""}, {"xxh3_128", ""}}})}};
  if (!report || !base::hasForm(*report, kForm) || (*report)["sectors"].size() != index.sector.size())
    return std::nullopt;
  for (std::size_t i = 0; i < index.sector.size(); ++i) {
    const Json& sector = (*report)["sectors"][i];
    const sectors::SectorEntry& entry = index.sector[i];
    if (sector["sector"] != nameOf(entry.id) || sector["xxh3_128"] != textOf(entry.checksum)) return std::nullopt;
  }
  return (*report)[kKey];
}

std::vector<std::string> worseThanNothing(const Json& certificate) {
  constexpr std::pair<const char*, const char*> kParts[] = {
      {"sky", "light of the sky"}, {"sun_bounce", "bounced light of sun and moon"}, {"local", "local light"}};
  std::vector<std::string> messages;
  for (const auto& [key, place] : {std::pair("surface", "on surfaces"), std::pair("air", "in the air")})
    for (const auto& [part, name] : kParts) {
      const Json& e = certificate[key].value(part, Json::object());
      if (!e.is_object() || !e.value("worse_than_nothing", false)) continue;
      messages.push_back(fmt::format("{} {} is {:.1f} % off; if it were left out, {:.1f} %", name, place,
                                     100.0 * e.value("rms", 0.0), 100.0 * e.value("nothing", 0.0)));
    }
  return messages;
}

void certifyBake(const LevelBake& level, const model::Sky& sky, const std::filesystem::path& folder,
                 const sectors::LevelIndex& index, bake::Certify how, const base::Progress& progress, Json& report) {
  if (how == bake::Certify::none || index.sector.empty()) return;
  const std::string subject = subjectOf(level, index, how);
  if (auto found = earlier(folder, subject)) {
    report[kKey] = std::move(*found);
    return warnOfWorse(report[kKey], report["warnings"]);
  }
  std::vector<sectors::SectorFile> files;
  for (const sectors::SectorEntry& s : index.sector) {
    const std::filesystem::path path = sectorPath(folder, s.id);
    files.push_back(sectors::decodeSector(base::readFile(path), path.string()));
  }
  std::size_t probes = 0;
  for (const sectors::SectorEntry& s : index.sector) probes += s.probes;
  const certify::CertifySettings settings = certifySettings(level, probes, how);
  const geometry::Tracer tracer(level.surfaces());
  Json found = {{"of", subject}};
  found.update(certificateJson(certify::certifyLevel(tracer, sky, files, settings, progress.stage("surfaces", 0))));
  report[kKey] = std::move(found);
  warnOfWorse(report[kKey], report["warnings"]);
}

}  // namespace welkin::build
