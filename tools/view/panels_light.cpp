// SPDX-License-Identifier: Apache-2.0
// The panels by which light is changed and compared.
#include <fmt/format.h>

#include "view/panels.h"
#include "view/widgets.h"

namespace welkin::view {

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

}  // namespace welkin::view
