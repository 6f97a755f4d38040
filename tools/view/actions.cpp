// SPDX-License-Identifier: Apache-2.0
#include "view/actions.h"

#include <fmt/format.h>

#include <cmath>

#include "probes/geometry/sector_name.h"
#include "sky/base/error.h"
#include "view/edit_actions.h"
#include "view/light_actions.h"
#include "view/session.h"
#include "view/state_json.h"
#include "view/words.h"

namespace welkin::view {
namespace {

constexpr double kFarthest_m = 1e6;

void time(Session& s, Words& w) {
  State state = s.state();
  const double time_h = w.number("the hour", 0.0, 24.0);
  state.time_h = time_h < 24.0 ? time_h : 0.0;
  w.end();
  s.set(state);
}

void camera(Session& s, Words& w) {
  State state = s.state();
  for (const auto& [axis, name] : {std::pair{0, "x"}, std::pair{1, "y"}, std::pair{2, "z"}}) {
    const double value = w.number(name, -kFarthest_m, kFarthest_m);
    (axis == 0 ? state.eye.position.x : axis == 1 ? state.eye.position.y : state.eye.position.z) = value;
  }
  state.eye.yaw_deg = w.number("yaw", -3600.0, 3600.0);
  state.eye.pitch_deg = w.number("pitch", -89.0, 89.0);
  if (!w.done()) state.eye.fov_deg = w.number("field of view", 1.0, 150.0);
  w.end();
  s.set(state);
}

void overview(Session& s, Words& w) {
  w.end();
  State state = s.state();
  state.eye = s.overview();
  s.set(state);
}

void undo(Session& s, Words& w) {
  w.end();
  s.undo();
}

void redo(Session& s, Words& w) {
  w.end();
  s.redo();
}

void click(Session& s, Words& w) {
  const double x = w.number("x", 0.0, s.width());
  const double y = w.number("y", 0.0, s.height());
  w.end();
  s.click(x, y);
}

void point(Session& s, Words& w) {
  State state = s.state();
  if (w.take("off")) {
    state.point.reset();
  } else {
    double v[6];
    for (std::size_t i = 0; i < 6; ++i)
      v[i] = w.number(i < 3 ? "the position" : "the normal", -kFarthest_m, kFarthest_m);
    const f64::Number3 normal(v[3], v[4], v[5]);
    const double length = std::sqrt(dot(normal, normal));
    if (!(length > 0.0))
      throw base::Error(base::ExitStatus::content, "point: the normal is 0 0 0, must have a direction");
    state.point = baked::SurfacePoint{f64::Number3(v[0], v[1], v[2]), normal / length};
    state.probe.reset();
  }
  w.end();
  s.set(state);
}

void truth(Session& s, Words& w) {
  State state = s.state();
  state.truth_paths = w.count("the number of paths", 1, std::size_t{1} << 24);
  w.end();
  s.set(state);
}

void paths(Session& s, Words& w) {
  State state = s.state();
  state.pixel_paths = w.count("the number of paths of a pixel", 1, 4096);
  w.end();
  s.set(state);
}

void bounds(Session& s, Words& w) {
  State state = s.state();
  state.bounds = w.isOn("bounds");
  w.end();
  s.set(state);
}

/// Looks at a place from 12 m away, from above the side where the camera is.
void flyTo(Session& s, const f64::Number3& place) {
  State state = s.state();
  f64::Number3 from = state.eye.position - place;
  const double across = std::hypot(from.x, from.z);
  from = across > 0.0 ? f64::Number3(from.x / across, 0.6, from.z / across) : f64::Number3(0.0, 0.6, 1.0);
  state.eye.position = place + from * 10.0;
  state.eye.yaw_deg = std::atan2(-from.x, from.z) / f64::kDegree;
  state.eye.pitch_deg = -std::atan2(0.6, 1.0) / f64::kDegree;
  s.set(state);
}

void fly(Session& s, Words& w) {
  const std::size_t kind = w.choice("the goal", {"warning", "sector", "point"});
  if (kind == 0) {
    const auto& warnings = s.level().warnings();
    if (warnings.empty()) throw base::Error(base::ExitStatus::content, "fly: the level has no warning");
    const std::size_t i = w.count("the warning", 0, warnings.size() - 1);
    w.end();
    if (warnings[i].place) flyTo(s, *warnings[i].place);
  } else if (kind == 1) {
    if (s.level().sectors().empty()) throw base::Error(base::ExitStatus::content, "fly: the level has no sector");
    const std::string& name = w.text("the sector");
    w.end();
    const auto id = geometry::sectorOf(name);
    const sectors::SectorFile* sector = id ? s.level().sector(*id) : nullptr;
    if (sector == nullptr)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("fly: the sector is \"{}\", must be one of the level, such as {}", name,
                                    nameOf(s.level().sectors().front().id)));
    flyTo(s, geometry::cornerOf(*id) + f64::Number3(32.0, sector->low_y, 32.0));
  } else {
    w.end();
    if (!s.state().point)
      throw base::Error(base::ExitStatus::content, "fly: no point is picked; point or click picks one");
    flyTo(s, s.state().point->position);
  }
}

void rates(Session& s, Words& w) {
  const std::size_t pictures = w.done() ? 20 : w.count("the number of pictures", 1, 10000);
  w.end();
  s.setRates(measureRates(s, pictures));
}

void screenshot(Session& s, Words& w) {
  const std::string path = w.text("the file");
  const bool moving = w.take("moving");
  w.end();
  s.host().screenshot(path, moving);
}

void state(Session& s, Words& w) {
  const std::string path = w.text("the file");
  w.end();
  writeState(s, path);
}

constexpr Action kActions[] = {
    {"time", "HOURS", "the time of day", time},
    {"camera", "X Y Z YAW PITCH [FOV]", "where the camera stands, metres, and looks, degrees", camera},
    {"overview", "", "a camera that sees the whole level", overview},
    {"fly", "warning N | sector X_Z | point", "takes the camera there", fly},
    {"click", "X Y", "picks what is at a pixel: a surface, or a probe's sphere", click},
    {"point", "X Y Z NX NY NZ | off", "picks a point of a surface", point},
    {"truth", "PATHS", "paths of the path tracer at the picked point", truth},
    {"paths", "N", "paths of the path tracer, a pixel", paths},
    {"probes", "off | irradiance | visibility | sky | sun-bounce | local", "what the spheres of probes show",
     shadeAction},
    {"other", "FOLDER", "opens another bake of the level, as the light `other`", otherAction},
    {"light", "baked | flat | sky | reference | other", "the ambient light of the picture", lightAction},
    {"compare", "LIGHT LIGHT [wipe [AT] | side | difference] | off", "two lights in one picture", compareAction},
    {"exposure", "STOPS | auto", "radiance is multiplied by 2^STOPS", exposureAction},
    {"set", "sky|sun-bounce|local|saturation NUMBER, tint|occlusion|contact|direct on|off", "changes the light at once",
     setAction},
    {"reset", "", "takes all changes of the light back", resetAction},
    {"undo", "", "takes the last change back", undo},
    {"redo", "", "makes it again", redo},
    {"bounds", "on | off", "the sectors' bounds", bounds},
    {"rates", "[PICTURES]", "measures pictures a second, while moving and when still", rates},
    {"screenshot", "FILE [moving]", "writes the picture and the panels as a PNG", screenshot},
    {"state", "FILE", "writes what the panels say as JSON", state},
    {"edit", "on | off", "shows what level.toml places by hand; clicks select it", editAction},
    {"probe", "add X Y Z|here, move N|selected X Y Z|here, delete N|selected, select N", "edits [probes] add",
     probeAction},
    {"room", "add X Y Z X Y Z, corner, delete N", "edits [[room]]; two corners are picked points", roomAction},
    {"save", "", "writes level.toml", saveAction},
    {"recover", "", "takes the edits that an earlier run did not save", recoverAction},
    {"discard", "", "drops them, or else those that are not saved", discardAction},
    {"rebake", "[SECTOR...]", "saves, and bakes what is out of date in the background", rebakeAction},
    {"cancel", "", "ends the rebake; the old sectors stay", cancelAction},
    {"wait", "[rebake | sector]", "until everything is computed, the rebake is done, or one more sector is",
     waitAction},
};

}  // namespace

std::span<const Action> actions() {
  return kActions;
}

void performAction(Session& session, const std::vector<std::string>& words) {
  std::string names;
  for (const Action& action : kActions) {
    if (words[0] == action.name) {
      Words rest(words);
      action.perform(session, rest);
      return;
    }
    names += (names.empty() ? "" : ", ") + std::string(action.name);
  }
  throw base::Error(base::ExitStatus::content, fmt::format("\"{}\" is not a command; those are {}", words[0], names));
}

}  // namespace welkin::view
