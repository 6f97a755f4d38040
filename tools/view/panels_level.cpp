// SPDX-License-Identifier: Apache-2.0
// The panels about a level: the picked point and probe, edits, warnings and cost.
#include <fmt/format.h>

#include <algorithm>

#include "probes/geometry/sector_name.h"
#include "view/panels.h"
#include "view/widgets.h"

namespace welkin::view {

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

}  // namespace welkin::view
