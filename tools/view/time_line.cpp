// SPDX-License-Identifier: Apache-2.0
#include "view/time_line.h"

#include <imgui.h>

#include <algorithm>

namespace welkin::view {
namespace {

constexpr ImU32 kNight = IM_COL32(30, 34, 60, 255);
constexpr ImU32 kDaylight = IM_COL32(120, 160, 210, 255);
constexpr ImU32 kKey = IM_COL32(255, 255, 255, 160);
constexpr ImU32 kSunTurn = IM_COL32(255, 170, 60, 255);
constexpr ImU32 kNow = IM_COL32(255, 255, 80, 255);

}  // namespace

std::optional<double> timeLine(const Day& day, double time_h) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(1.0F, ImGui::GetContentRegionAvail().x), 26.0F * ImGui::GetIO().FontGlobalScale};
  const auto x = [&](double hour) { return low.x + size.x * static_cast<float>(hour / 24.0); };
  ImGui::InvisibleButton("time line", size);
  for (std::size_t i = 0; i + 1 < kDaySamples; ++i)
    draw.AddRectFilled({x(0.25 * static_cast<double>(i)), low.y},
                       {x(0.25 * static_cast<double>(i + 1)), low.y + size.y},
                       day.elevation_deg[i] > 0.0F ? kDaylight : kNight);
  const auto mark = [&](double hour, float share, ImU32 colour, float width) {
    draw.AddRectFilled({x(hour) - 0.5F * width, low.y + size.y * (1.0F - share)},
                       {x(hour) + 0.5F * width, low.y + size.y}, colour);
  };
  for (const float hour : day.key_h) mark(double{hour}, 0.35F, kKey, 1.0F);
  for (const auto* turns : {&day.sunrise_h, &day.sunset_h})
    for (const double hour : *turns) mark(hour, 1.0F, kSunTurn, 2.0F);
  mark(time_h, 1.0F, kNow, 3.0F);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("white: keys of the table; orange: sunrise and sunset");
  if (!ImGui::IsItemActive()) return std::nullopt;
  const double share = std::clamp(double{(ImGui::GetIO().MousePos.x - low.x) / size.x}, 0.0, 1.0);
  const double hour = std::min(24.0 * share, 23.999);
  return hour == time_h ? std::nullopt : std::optional(hour);
}

void dayCurve(const std::array<float, kDaySamples>& curve, double time_h) {
  const auto [least, most] = std::minmax_element(curve.begin(), curve.end());
  const float low = std::min(*least, 0.0F), high = std::max(*most, low + 1e-6F);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, 60.0F * ImGui::GetIO().FontGlobalScale};
  ImGui::PlotLines("##curve", curve.data(), static_cast<int>(curve.size()), 0, nullptr, low, high, size);
  const float x = corner.x + size.x * static_cast<float>(time_h / 24.0);
  ImGui::GetWindowDrawList()->AddRectFilled({x - 1.0F, corner.y}, {x + 1.0F, corner.y + size.y}, kNow);
  const auto index = static_cast<std::size_t>(time_h * 4.0);
  ImGui::TextDisabled("now %.4g, from %.4g to %.4g", double{curve[std::min(index, kDaySamples - 1)]}, double{*least},
                      double{*most});
}

}  // namespace welkin::view
