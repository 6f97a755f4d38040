// SPDX-License-Identifier: Apache-2.0
#include "view/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "render/picture.h"
#include "sky/base/error.h"
#include "view/actions.h"
#include "view/overlay.h"
#include "view/time_line.h"
#include "view/widgets.h"

namespace welkin::view {
namespace {

constexpr float kPanelWidth = 310.0F;
constexpr float kMargin = 8.0F;

}  // namespace

Panels::Panels(Session& session) : session_(session), context_(ImGui::CreateContext()) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // more than 65536 vertices in a list
  io.IniFilename = nullptr;                                   // the layout is the same every time
  io.Fonts->Flags |= ImFontAtlasFlags_NoBakedLines;           // the pipeline reads texels and does not filter
  ImGui::StyleColorsDark();
  ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0.82F;
  ImGui::GetStyle().WindowRounding = 4.0F;
}

Panels::~Panels() {
  ImGui::DestroyContext(context_);
}

void Panels::perform(const std::string& line) {
  try {
    complaint_.clear();
    session_.perform(line);
  } catch (const base::Error& error) {
    complain(error.what());
  }
}

void Panels::performDragged(const std::string& line) {
  session_.joinChanges(dragged_step_ > 0 && dragged_step_ == session_.undoCount());
  perform(line);
  session_.joinChanges(false);
  dragged_step_ = session_.undoCount();
}

const ImDrawData& Panels::build() {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(session_.width()), static_cast<float>(session_.height())};
  io.FontGlobalScale = session_.height() >= 1600 ? 2.0F : 1.0F;
  if (!(io.DeltaTime > 0.0F)) io.DeltaTime = 1.0F / 60.0F;
  ImGui::NewFrame();
  drawOverlay(session_);
  const float width = std::min(kPanelWidth * io.FontGlobalScale, 0.48F * io.DisplaySize.x);
  const float height = io.DisplaySize.y - 2.0F * kMargin;
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize;
  ImGui::SetNextWindowPos({kMargin, kMargin});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, height});
  if (ImGui::Begin("Sky and light", nullptr, kFixed)) {
    time();
    see();
    change();
    compare();
    help();
    if (!complaint_.empty()) say(complaint_);
  }
  ImGui::End();
  ImGui::SetNextWindowPos({io.DisplaySize.x - width - kMargin, kMargin});
  ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, height});
  if (ImGui::Begin("Level", nullptr, kFixed)) {
    point();
    probe();
    edit();
    warnings();
    cost();
  }
  ImGui::End();
  ImGui::Render();
  return *ImGui::GetDrawData();
}

const ImDrawData& Panels::settled() {
  build();  // windows find their size in the first frame, and use it from the second on
  build();
  return build();
}

void Panels::time() {
  const State& s = session_.state();
  const WelkinSkySample& sample = session_.sample();
  ImGui::Text("%s", render::clockLabel(s.time_h).c_str());
  ImGui::SameLine();
  const double height = std::clamp(double{sample.sun.direction[1]}, -1.0, 1.0);
  ImGui::TextDisabled("sun %.1f deg, illuminance %.3g", std::asin(height) / f64::kDegree,
                      double{sample.sun.illuminance});
  if (const auto time_h = timeLine(session_.day(), s.time_h)) perform(fmt::format("time {}", *time_h));
  if (!header("Curves over the day", false)) return;
  const Day& day = session_.day();
  const struct {
    const char* name;
    const std::array<float, kDaySamples>& curve;
  } curves[] = {{"light of open ground", day.irradiance},
                {"intensity", day.intensity},
                {"tint", day.tint},
                {"saturation", day.saturation},
                {"sun's elevation", day.elevation_deg}};
  const char* names[] = {curves[0].name, curves[1].name, curves[2].name, curves[3].name, curves[4].name};
  const int chosen = choice("curve", names, static_cast<std::size_t>(curve_));
  if (chosen >= 0) curve_ = chosen;
  dayCurve(curves[curve_].curve, s.time_h);
}

void Panels::see() {
  if (!header("See")) return;
  const State& s = session_.state();
  int chosen = choice("light", kLights, static_cast<std::size_t>(s.light));
  if (chosen >= 0) perform(std::string("light ") + kLights[chosen]);
  chosen = choice("probes", kProbeShades, static_cast<std::size_t>(s.probes));
  if (chosen >= 0) perform(std::string("probes ") + kProbeShades[chosen]);
  bool on = s.bounds;
  if (ImGui::Checkbox("sectors", &on)) perform(on ? "bounds on" : "bounds off");
  ImGui::SameLine();
  on = !s.exposure_ev.has_value();
  if (ImGui::Checkbox("auto exposure", &on)) perform(on ? "exposure auto" : "exposure 0");
  ImGui::SameLine();
  if (ImGui::Button("overview")) perform("overview");
  if (!s.exposure_ev) return;
  auto ev = static_cast<float>(*s.exposure_ev);
  ImGui::SetNextItemWidth(150.0F * ImGui::GetIO().FontGlobalScale);
  if (ImGui::SliderFloat("stops", &ev, -16.0F, 16.0F, "%.1f")) perform(fmt::format("exposure {}", ev));
}

void Panels::help() {
  if (!header("Help", false)) return;
  say("Left: pick. Right: look around. Wheel: nearer, farther. W A S D Q E: walk. Space: play the day. P: probes. N: "
      "probe at the point. M: moves "
      "the selected one there. Delete: deletes it. R, R: room. Ctrl+S: save. F5: rebake. "
      "Ctrl+Z, Ctrl+Y: undo, redo. F12: screenshot. Commands of a script:");
  for (const Action& action : actions()) say(fmt::format("{} {}", action.name, action.arguments));
}

}  // namespace welkin::view
