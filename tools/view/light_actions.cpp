// SPDX-License-Identifier: Apache-2.0
#include "view/light_actions.h"

#include "sky/base/error.h"
#include "view/session.h"
#include "view/words.h"

namespace welkin::view {
namespace {

constexpr double kMostFactor = 16.0;

Light lightWord(const Session& s, Words& w, const char* what) {
  const auto light = static_cast<Light>(w.choice(what, {"baked", "flat", "sky", "reference", "other"}));
  if (light == Light::other && !s.hasOther())
    throw base::Error(base::ExitStatus::content, "other: no other bake is open; `other FOLDER` opens one");
  return light;
}

}  // namespace

void shadeAction(Session& s, Words& w) {
  State state = s.state();
  state.probes =
      static_cast<ProbeShade>(w.choice("the shade", {"off", "irradiance", "visibility", "sky", "sun-bounce", "local"}));
  w.end();
  s.set(state);
}

void otherAction(Session& s, Words& w) {
  const std::string folder = w.text("the folder");
  w.end();
  s.openOther(folder);
}

void lightAction(Session& s, Words& w) {
  State state = s.state();
  state.light = lightWord(s, w, "the light");
  w.end();
  s.set(state);
}

void compareAction(Session& s, Words& w) {
  State state = s.state();
  if (w.take("off")) {
    state.compare.reset();
  } else {
    Comparison c;
    c.first = lightWord(s, w, "the first light");
    c.second = lightWord(s, w, "the second light");
    if (!w.done()) c.beside = static_cast<Beside>(w.choice("the arrangement", {"wipe", "side", "difference"}));
    if (c.beside == Beside::wipe && !w.done()) c.at = w.number("the line", 0.0, 1.0);
    state.compare = c;
  }
  w.end();
  s.set(state);
}

void exposureAction(Session& s, Words& w) {
  State state = s.state();
  if (w.take("auto"))
    state.exposure_ev.reset();
  else
    state.exposure_ev = w.number("the exposure in stops, or auto,", -40.0, 40.0);
  w.end();
  s.set(state);
}

void setAction(Session& s, Words& w) {
  State state = s.state();
  Changes& c = state.changes;
  switch (
      w.choice("the name", {"sky", "sun-bounce", "local", "saturation", "tint", "occlusion", "contact", "direct"})) {
    case 0:
      c.sky = w.number("sky", 0.0, kMostFactor);
      break;
    case 1:
      c.sun_bounce = w.number("sun-bounce", 0.0, kMostFactor);
      break;
    case 2:
      c.local = w.number("local", 0.0, kMostFactor);
      break;
    case 3:
      c.saturation = w.number("saturation", 0.0, 1.0);
      break;
    case 4:
      c.tint = w.isOn("tint");
      break;
    case 5:
      c.occlusion = w.isOn("occlusion");
      break;
    case 6:
      c.contact = w.isOn("contact");
      break;
    default:
      c.direct = w.isOn("direct");
      break;
  }
  w.end();
  if (c != s.state().changes) s.set(state);
}

void resetAction(Session& s, Words& w) {
  w.end();
  State state = s.state();
  state.changes = {};
  if (state.changes != s.state().changes) s.set(state);
}

}  // namespace welkin::view
