// SPDX-License-Identifier: Apache-2.0
#include "view/state_json.h"

#include <cmath>

#include "probes/geometry/sector_name.h"
#include "render/tone.h"
#include "sky/base/atomic_file.h"

namespace welkin::view {
namespace {

using Json = nlohmann::ordered_json;
using f64::Number3;

Json json(const Number3& v) {
  return {v.x, v.y, v.z};
}

Json json(const Float3& v) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Json json(const float (&v)[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Json lightJson(const WelkinLight& light) {
  return {{"direction", json(light.direction)},
          {"elevation_deg", std::asin(std::clamp(double{light.direction[1]}, -1.0, 1.0)) / f64::kDegree},
          {"illuminance", double{light.illuminance}}};
}

Json nameJson(const ProbeName& name) {
  return {{"sector", nameOf(name.sector)}, {"number", name.number}};
}

Json json(const CellOfPoint& cell) {
  Json result = {{"low", json(cell.box.low)}, {"weight", cell.weight}, {"share", cell.share}, {"part", cell.part}};
  if (cell.probe) result["probe"] = nameJson(*cell.probe);
  return result;
}

Json json(const Answer& a) {
  Json result = {{"position", json(a.point.position)}, {"normal", json(a.point.normal)}, {"light", nullptr}};
  if (a.light)
    result["light"] = {
        {"irradiance", json(a.light->irradiance)},
        {"components",
         {{"sky", json(a.light->sky)}, {"sun_bounce", json(a.light->sun_bounce)}, {"local", json(a.light->local)}}}};
  result["cells"] = Json::array();
  for (std::size_t i = 0; i < a.cell_count; ++i) result["cells"].push_back(json(a.cells[i]));
  result["expected"] = json(a.expected);
  result["truth"] = {{"irradiance", json(a.truth.total.value)},
                     {"standard_error", json(a.truth.total.standard_error)},
                     {"components",
                      {{"sky", json(a.truth.sky.value)},
                       {"sun_bounce", json(a.truth.sun_bounce.value)},
                       {"local", json(a.truth.local.value)}}},
                     {"samples", a.truth.samples}};
  result["error"] = a.error;
  result["noise"] = a.noise;
  result["verdict"] = kVerdicts[static_cast<std::size_t>(a.verdict)];
  result["words"] = a.words;
  return result;
}

Json json(const ProbeNumbers& p) {
  Json result = nameJson(p.name);
  result["position"] = json(p.position);
  result["up"] = json(p.up);
  result["down"] = json(p.down);
  result["components"] = {{"sky", json(p.sky)}, {"sun_bounce", json(p.sun_bounce)}, {"local", json(p.local)}};
  result["visibility"] = p.visibility;
  result["bytes"] = p.bytes;
  return result;
}

Json costJson(const Level& level) {
  Json sectors = Json::array();
  std::size_t bytes = 0, probes = 0;
  for (const SectorCost& cost : level.costs()) {
    sectors.push_back({{"name", nameOf(cost.id)}, {"probes", cost.probes}, {"bytes", cost.bytes}});
    bytes += cost.bytes;
    probes += cost.probes;
  }
  return {{"bytes", bytes}, {"probes", probes}, {"sectors", sectors}};
}

Json warningsJson(const Level& level) {
  Json list = Json::array();
  for (const Warning& warning : level.warnings()) {
    list.push_back({{"id", warning.id}, {"message", warning.message}});
    if (warning.place) list.back()["place"] = json(*warning.place);
  }
  return list;
}

Json compareJson(Session& session) {
  if (!session.state().compare) return nullptr;
  const Comparison& c = *session.state().compare;
  session.picture();  // the error is of it
  const render::IrradianceError& e = *session.error();
  Json result = {{"first", kLights[static_cast<std::size_t>(c.first)]},
                 {"second", kLights[static_cast<std::size_t>(c.second)]},
                 {"beside", kBeside[static_cast<std::size_t>(c.beside)]}};
  if (c.beside == Beside::wipe) result["at"] = c.at;
  result["error"] = {{"unit", e.unit},   {"mean", e.mean},   {"rms", e.rms},
                     {"worst", e.worst}, {"noise", e.noise}, {"pixels", e.pixels}};
  return result;
}

Json editJson(const Session& session) {
  const LevelEdits& edits = session.edits();
  Json result = {{"file", edits.path().string()},
                 {"probes", edits.placed().probes},
                 {"rooms", edits.placed().rooms},
                 {"unsaved", edits.unsaved()},
                 {"unbaked", session.editsUnbaked()},
                 {"offers", edits.offers()},
                 {"selected", nullptr}};
  if (session.state().hand) result["selected"] = *session.state().hand;
  return result;
}

Json rebakeJson(const Session& session) {
  const RebakeStatus* r = session.rebakeStatus();
  if (r == nullptr) return nullptr;
  Json sectors = Json::array();
  for (const geometry::SectorId id : r->finished) sectors.push_back(nameOf(id));
  return {{"state", kRebakeStates[static_cast<std::size_t>(r->state)]}, {"sectors", sectors}, {"message", r->message}};
}

Json ratesJson(const Session& session) {
  const Rates* r = session.rates();
  if (r == nullptr) return nullptr;
  const auto passes = [](const std::vector<render::PassTime>& times) {
    Json list = Json::object();
    for (const render::PassTime& pass : times) list[pass.name] = pass.milliseconds;
    return list;
  };
  return {{"moving", r->moving},
          {"still", r->still},
          {"pictures", r->pictures},
          {"divisor", r->divisor},
          {"width", r->width},
          {"height", r->height},
          {"moving_pass_ms", passes(r->moving_pass)},
          {"still_pass_ms", passes(r->still_pass)}};
}

}  // namespace

Json stateJson(Session& session) {
  const State& s = session.state();
  const WelkinSkySample& sample = session.sample();
  const Day& day = session.day();
  Json state = {{"time_h", s.time_h},
                {"camera",
                 {{"position", json(s.eye.position)},
                  {"yaw_deg", s.eye.yaw_deg},
                  {"pitch_deg", s.eye.pitch_deg},
                  {"fov_deg", s.eye.fov_deg}}},
                {"sun", lightJson(sample.sun)},
                {"sunrise_h", day.sunrise_h},
                {"sunset_h", day.sunset_h},
                {"keys_h", day.key_h},
                {"sky",
                 {{"intensity", double{sample.intensity}},
                  {"ambient_saturation", double{sample.ambient_saturation}},
                  {"polarising_tint", json(sample.polarising_tint)},
                  {"ground_radiance", json(sample.ground_radiance)},
                  {"open_ground", render::openGround(sample)}}},
                {"light", kLights[static_cast<std::size_t>(s.light)]},
                {"probes", kProbeShades[static_cast<std::size_t>(s.probes)]},
                {"exposure", s.exposure_ev ? Json(*s.exposure_ev) : Json("auto")},
                {"changes",
                 {{"sky", s.changes.sky},
                  {"sun_bounce", s.changes.sun_bounce},
                  {"local", s.changes.local},
                  {"saturation", s.changes.saturation},
                  {"tint", s.changes.tint},
                  {"occlusion", s.changes.occlusion},
                  {"contact", s.changes.contact},
                  {"direct", s.changes.direct}}},
                {"contact_factors", session.level().scene().contact.size()},
                {"undo", session.undoCount()},
                {"redo", session.redoCount()},
                {"compare", compareJson(session)},
                {"pick", nullptr},
                {"probe", nullptr},
                {"rates", ratesJson(session)},
                {"edit", editJson(session)},
                {"rebake", rebakeJson(session)},
                {"cost", costJson(session.level())},
                {"warnings", warningsJson(session.level())}};
  if (const Answer* answer = session.answer()) state["pick"] = json(*answer);
  if (const ProbeNumbers* probe = session.probe()) state["probe"] = json(*probe);
  return state;
}

void writeState(Session& session, const std::string& path) {
  base::writeFile(path, stateJson(session).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace welkin::view
