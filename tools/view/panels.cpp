// SPDX-License-Identifier: Apache-2.0
#include "view/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "probes/geometry/sector_name.h"
#include "render/picture.h"
#include "sky/base/error.h"
#include "view/actions.h"
#include "view/overlay.h"
#include "view/time_line.h"

namespace welkin::view {
namespace {

constexpr float kPanelWidth = 310.0F;
constexpr float kMargin = 8.0F;

/// Text that is never a format.
void say(const std::string& text) {
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

bool header(const char* name, bool open = true) {
  return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

/// A choice among names; the chosen index, or -1 if nothing was clicked.
template <std::size_t N>
int choice(const char* label, const char* const (&names)[N], std::size_t now) {
  int index = static_cast<int>(now);
  ImGui::SetNextItemWidth(150.0F * ImGui::GetIO().FontGlobalScale);
  return ImGui::Combo(label, &index, names, static_cast<int>(N)) ? index : -1;
}

bool slider(const char* label, double now, float high, float& value) {
  value = static_cast<float>(now);
  ImGui::SetNextItemWidth(150.0F * ImGui::GetIO().FontGlobalScale);
  return ImGui::SliderFloat(label, &value, 0.0F, high, "%.2f", ImGuiSliderFlags_AlwaysClamp);
}

std::string rgbText(const f64::Number3& v) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", v.x, v.y, v.z);
}

std::string rgbText(const Float3& v) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", v[0], v[1], v[2]);
}

void row(const char* name, const std::string& text) {
  ImGui::TextUnformatted(name);
  ImGui::SameLine(90.0F * ImGui::GetIO().FontGlobalScale);
  ImGui::TextUnformatted(text.c_str());
}

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

void Panels::change() {
  if (!header("Change")) return;
  const Changes& c = session_.state().changes;
  const auto factor = [&](const char* label, const char* name, double now, float high) {
    float value = 0.0F;
    const bool changed = slider(label, now, high, value);
    if (ImGui::IsItemActivated()) dragged_step_ = 0;
    if (changed) performDragged(fmt::format("set {} {}", name, value));
  };
  factor("sky", "sky", c.sky, 4.0F);
  factor("bounced sun", "sun-bounce", c.sun_bounce, 4.0F);
  factor("emission, lamps", "local", c.local, 4.0F);
  factor("saturation", "saturation", c.saturation, 1.0F);
  const auto flag = [&](const char* name, bool now) {
    bool on = now;
    if (ImGui::Checkbox(name, &on)) perform(fmt::format("set {} {}", name, on ? "on" : "off"));
  };
  flag("tint", c.tint);
  ImGui::SameLine();
  flag("occlusion", c.occlusion);
  if (!session_.level().scene().contact.empty()) {
    ImGui::SameLine();
    flag("contact", c.contact);
  }
  ImGui::SameLine();
  flag("direct", c.direct);
  if (ImGui::Button("undo")) perform("undo");
  ImGui::SameLine();
  if (ImGui::Button("redo")) perform("redo");
  ImGui::SameLine();
  if (ImGui::Button("reset")) perform("reset");
  ImGui::SameLine();
  ImGui::TextDisabled("%zu undo, %zu redo", session_.undoCount(), session_.redoCount());
}

void Panels::compare() {
  if (!header("Compare")) return;
  const std::optional<Comparison>& now = session_.state().compare;
  Comparison c = now.value_or(Comparison{});
  const auto send = [&] {
    const auto name = [](const auto& names, auto value) { return names[static_cast<std::size_t>(value)]; };
    const std::string at = c.beside == Beside::wipe ? fmt::format(" {}", c.at) : "";
    perform(fmt::format("compare {} {} {}{}", name(kLights, c.first), name(kLights, c.second), name(kBeside, c.beside),
                        at));
  };
  bool on = now.has_value();
  if (ImGui::Checkbox("compare", &on)) on ? send() : perform("compare off");
  if (!now) return;
  int chosen = choice("left", kLights, static_cast<std::size_t>(c.first));
  if (chosen >= 0) c.first = static_cast<Light>(chosen), send();
  chosen = choice("right", kLights, static_cast<std::size_t>(c.second));
  if (chosen >= 0) c.second = static_cast<Light>(chosen), send();
  chosen = choice("as", kBeside, static_cast<std::size_t>(c.beside));
  if (chosen >= 0) c.beside = static_cast<Beside>(chosen), send();
  float at = 0.0F;
  if (c.beside == Beside::wipe && slider("line", c.at, 1.0F, at)) c.at = double{at}, send();
  if (const render::IrradianceError* e = session_.error())
    say(fmt::format("left minus right: {}", render::errorText(*e)));
}

void Panels::point() {
  if (!header("What lights this point?")) return;
  const Answer* a = session_.answer();
  if (a == nullptr) return say(session_.state().point ? "Computed when the picture is still." : "Click a surface.");
  row("at", rgbText(a->point.position));
  row("normal", rgbText(a->point.normal));
  if (a->light) {
    row("probes", rgbText(a->light->irradiance));
    row("  sky", rgbText(a->light->sky));
    row("  sun", rgbText(a->light->sun_bounce));
    row("  local", rgbText(a->light->local));
  }
  row("truth", rgbText(a->truth.total.value));
  row("  +-", rgbText(a->truth.total.standard_error));
  if (a->expected != a->truth.total.value) row("  scaled", rgbText(a->expected));
  const bool right = a->verdict == Verdict::right;
  ImGui::PushStyleColor(ImGuiCol_Text, right ? ImVec4{0.5F, 1.0F, 0.5F, 1.0F} : ImVec4{1.0F, 0.6F, 0.4F, 1.0F});
  say(a->words);
  ImGui::PopStyleColor();
  for (std::size_t i = 0; i < a->cell_count; ++i) {
    const CellOfPoint& cell = a->cells[i];
    const std::string probe =
        cell.probe ? fmt::format("{} #{}", nameOf(cell.probe->sector), cell.probe->number) : std::string("-");
    row(fmt::format("{:4.0f} %", 100.0 * cell.share).c_str(), fmt::format("{:<10} {}", probe, cell.part));
  }
}

void Panels::probe() {
  if (!header("Probe")) return;
  const ProbeNumbers* p = session_.probe();
  if (p == nullptr) return say("Show the probes and click one.");
  row("probe", fmt::format("{} #{}, {} bytes", nameOf(p->name.sector), p->name.number, p->bytes));
  row("at", rgbText(p->position));
  row("up", rgbText(p->up));
  row("  sky", rgbText(p->sky));
  row("  sun", rgbText(p->sun_bounce));
  row("  local", rgbText(p->local));
  row("down", rgbText(p->down));
  row("sees", fmt::format("{:.0f} % of an open sky", 100.0 * p->visibility));
}

void Panels::edit() {
  const LevelEdits& edits = session_.edits();
  const HandPlaced& placed = edits.placed();
  const std::string name = fmt::format("Edit: probes by hand {}, rooms {}{}###edit", placed.probes.size(),
                                       placed.rooms.size(), edits.unsaved() ? " *" : "");
  if (!header(name.c_str(), edits.offers() || session_.rebakes() || session_.state().edit)) return;
  if (edits.offers()) {
    say("An earlier run has left edits that it did not save.");
    if (ImGui::Button("recover")) perform("recover");
    ImGui::SameLine();
    if (ImGui::Button("discard")) perform("discard");
    return;
  }
  bool on = session_.state().edit;
  if (ImGui::Checkbox("show", &on)) perform(on ? "edit on" : "edit off");
  const auto button = [&](const char* label, const char* command, bool same_line = true) {
    if (same_line) ImGui::SameLine();
    if (ImGui::Button(label)) perform(command);
  };
  button("add probe", "probe add here");
  button(session_.state().corner ? "other corner" : "room", "room corner");
  if (session_.state().hand) {
    const ProbePlace& p = placed.probes[*session_.state().hand];
    row(fmt::format("probe {}", *session_.state().hand).c_str(), fmt::format("{:.2f} {:.2f} {:.2f}", p[0], p[1], p[2]));
    button("move here", "probe move selected here", false);
    button("delete", "probe delete selected");
  }
  for (std::size_t i = 0; i < placed.rooms.size() && session_.state().edit; ++i) {
    const RoomBox& b = placed.rooms[i];
    ImGui::PushID(static_cast<int>(i));
    button("delete", fmt::format("room delete {}", i).c_str(), false);
    ImGui::SameLine();
    say(fmt::format("room {:.1f} x {:.1f} x {:.1f} m", b[3] - b[0], b[4] - b[1], b[5] - b[2]));
    ImGui::PopID();
  }
  button("save", "save", false);
  const RebakeStatus* status = session_.rebakeStatus();
  if (session_.rebakes()) {
    button("cancel", "cancel");
    const float share = status->total > 0 ? static_cast<float>(status->done) / static_cast<float>(status->total) : 0.0F;
    ImGui::ProgressBar(share, {-1.0F, 0.0F},
                       fmt::format("{} {}/{}", status->stage, status->done, status->total).c_str());
    return;
  }
  button("rebake", "rebake");
  if (session_.editsUnbaked()) say("The picture is of level.toml as it was before.");
  if (status != nullptr)
    say(fmt::format("rebake {}, {} sectors{}{}", kRebakeStates[static_cast<std::size_t>(status->state)],
                    status->finished.size(), status->message.empty() ? "" : ": ", status->message));
}

void Panels::warnings() {
  const std::vector<Warning>& list = session_.level().warnings();
  if (!header(fmt::format("Warnings: {}###warnings", list.size()).c_str())) return;
  for (std::size_t i = 0; i < list.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (list[i].place && ImGui::SmallButton("go")) perform(fmt::format("fly warning {}", i));
    if (list[i].place) ImGui::SameLine();
    say(list[i].message);
    ImGui::PopID();
  }
}

void Panels::cost() {
  std::size_t bytes = 0, most = 1, probes = 0;
  for (const SectorCost& cost : session_.level().costs()) {
    bytes += cost.bytes;
    probes += cost.probes;
    most = std::max(most, cost.bytes);
  }
  if (!header(fmt::format("Cost: {} probes, {} KB###cost", probes, (bytes + 512) / 1024).c_str(), false)) return;
  for (const SectorCost& cost : session_.level().costs()) {
    const std::string name = nameOf(cost.id);
    if (ImGui::SmallButton(name.c_str())) perform("fly sector " + name);
    ImGui::SameLine(70.0F * ImGui::GetIO().FontGlobalScale);
    ImGui::ProgressBar(static_cast<float>(cost.bytes) / static_cast<float>(most), {-1.0F, 0.0F},
                       fmt::format("{} probes, {} bytes", cost.probes, cost.bytes).c_str());
  }
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
