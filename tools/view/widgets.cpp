// SPDX-License-Identifier: Apache-2.0
#include "view/widgets.h"

#include <fmt/format.h>

namespace welkin::view {

void say(const std::string& text) {
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

bool header(const char* name, bool open) {
  return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

int choice(const char* label, const char* const* names, std::size_t count, std::size_t now) {
  int index = static_cast<int>(now);
  ImGui::SetNextItemWidth(150.0F * ImGui::GetIO().FontGlobalScale);
  return ImGui::Combo(label, &index, names, static_cast<int>(count)) ? index : -1;
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

}  // namespace welkin::view
