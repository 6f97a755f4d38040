// SPDX-License-Identifier: Apache-2.0
#include "view/edit_actions.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "probes/geometry/sector_name.h"
#include "sky/base/error.h"
#include "view/session.h"
#include "view/words.h"

namespace welkin::view {
namespace {

using f64::Number3;

constexpr double kFarthestEdit_m = 1e6;
constexpr double kAbove_m = 1.0;         // a probe stands so far from the surface that was picked, as [probes] height_m
constexpr double kThinnest_m = 0.1;      // of a room
constexpr double kRoomHeight_m = 3.0;    // under the open sky
constexpr double kHighestRoom_m = 20.0;  // a ceiling farther up is none

template <std::size_t N>
std::array<double, N> numbersIn(Words& w, const char* what) {
  std::array<double, N> numbers{};
  for (double& number : numbers) number = w.number(what, -kFarthestEdit_m, kFarthestEdit_m);
  w.end();
  return numbers;
}

const baked::SurfacePoint& pickedPoint(const Session& s, const char* command) {
  if (!s.state().point)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: no point is picked; point or click picks one", command));
  return *s.state().point;
}

/// Above the picked point, in the middle where something is nearer than twice the distance.
ProbePlace placeAbove(Session& s) {
  const baked::SurfacePoint& point = pickedPoint(s, "probe");
  const Number3 from = point.position + point.normal * 1e-3;
  const auto hit = s.level().tracer().closest(from, point.normal, 2.0 * kAbove_m);
  const Number3 place = point.position + point.normal * (hit ? 0.5 * hit->distance : kAbove_m);
  return {place.x, place.y, place.z};
}

std::size_t handProbe(const Session& s, Words& w) {
  const std::size_t count = s.edits().placed().probes.size();
  if (count == 0)
    throw base::Error(base::ExitStatus::content, "probe: level.toml has no probe by hand; `probe add` adds one");
  if (w.take("selected")) {
    if (!s.state().hand)
      throw base::Error(base::ExitStatus::content, "probe: no probe by hand is selected; a click selects one");
    return *s.state().hand;
  }
  return w.count("the probe", 0, count - 1);
}

void select(Session& s, std::optional<std::size_t> number) {
  State state = s.state();
  state.edit = true;
  state.hand = number;
  s.set(state);
}

/// The box between two picked points: from the lower one up to the ceiling.
RoomBox roomBetween(Session& s, const Number3& a, const Number3& b) {
  const Number3 low(std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z));
  const Number3 high(std::max(a.x, b.x), low.y, std::max(a.z, b.z));
  if (high.x - low.x < kThinnest_m || high.z - low.z < kThinnest_m)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("room: the corners are less than {} m apart along x or z", kThinnest_m));
  const Number3 middle = (low + high) * 0.5;
  const auto ceiling = s.level().tracer().closest(middle + Number3(0.0, 0.1, 0.0), {0.0, 1.0, 0.0}, kHighestRoom_m);
  return {low.x, low.y, low.z, high.x, ceiling ? ceiling->position.y : low.y + kRoomHeight_m, high.z};
}

}  // namespace

void probeAction(Session& s, Words& w) {
  switch (w.choice("what to do", {"add", "move", "delete", "select"})) {
    case 0: {
      const bool here = w.take("here");
      if (here) w.end();
      s.edit(withProbe(s.edits().text(), here ? placeAbove(s) : numbersIn<3>(w, "a coordinate")));
      return select(s, s.edits().placed().probes.size() - 1);
    }
    case 1: {
      const std::size_t number = handProbe(s, w);
      const bool here = w.take("here");
      if (here) w.end();
      s.edit(withProbeMoved(s.edits().text(), number, here ? placeAbove(s) : numbersIn<3>(w, "a coordinate")));
      return select(s, number);
    }
    case 2: {
      const std::size_t number = handProbe(s, w);
      w.end();
      s.edit(withoutProbe(s.edits().text(), number));
      return select(s, std::nullopt);
    }
    default: {
      const std::size_t number = handProbe(s, w);
      w.end();
      return select(s, number);
    }
  }
}

void roomAction(Session& s, Words& w) {
  switch (w.choice("what to do", {"add", "corner", "delete"})) {
    case 0: {
      const RoomBox box = numbersIn<6>(w, "a coordinate");
      for (std::size_t i = 0; i < 3; ++i)
        if (!(box[i] < box[i + 3]))
          throw base::Error(base::ExitStatus::content, "room: the first corner must be below the second on each axis");
      return s.edit(withRoom(s.edits().text(), box));
    }
    case 1: {
      w.end();
      const Number3 here = pickedPoint(s, "room").position;
      State state = s.state();
      state.edit = true;
      const std::optional<Number3> first = state.corner;
      state.corner = first ? std::nullopt : std::optional(here);
      if (first) s.edit(withRoom(s.edits().text(), roomBetween(s, *first, here)));
      return s.set(state);
    }
    default: {
      const std::size_t count = s.edits().placed().rooms.size();
      if (count == 0) throw base::Error(base::ExitStatus::content, "room: level.toml has no room");
      const std::size_t number = w.count("the room", 0, count - 1);
      w.end();
      return s.edit(withoutRoom(s.edits().text(), number));
    }
  }
}

void editAction(Session& s, Words& w) {
  State state = s.state();
  state.edit = w.isOn("edit");
  w.end();
  s.set(state);
}

void saveAction(Session& s, Words& w) {
  w.end();
  s.save();
}

void recoverAction(Session& s, Words& w) {
  w.end();
  s.recover();
}

void discardAction(Session& s, Words& w) {
  w.end();
  s.discard();
}

void rebakeAction(Session& s, Words& w) {
  std::string sectors;
  while (!w.done()) {
    const std::string& name = w.text("the sector");
    const auto id = geometry::sectorOf(name);
    if (!id || s.level().sector(*id) == nullptr)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("rebake: the sector is \"{}\", must be one of the level", name));
    sectors += (sectors.empty() ? "" : ",") + name;
  }
  s.rebake(sectors);
}

void cancelAction(Session& s, Words& w) {
  w.end();
  s.cancelRebake();
}

void waitAction(Session& s, Words& w) {
  const bool sector = w.take("sector"), rebake = !sector && w.take("rebake");
  w.end();
  const std::size_t shown = s.rebakeStatus() ? s.rebakeStatus()->finished.size() : 0;
  while ((sector || rebake) && s.rebakes()) {
    s.advance();
    if (sector && s.rebakeStatus()->finished.size() > shown) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (rebake && s.rebakeStatus() && s.rebakeStatus()->state == RebakeState::failed)
    throw base::Error(base::ExitStatus::content, "rebake: " + s.rebakeStatus()->message);
  s.picture();
  s.answer();
  s.probe();
}

}  // namespace welkin::view
