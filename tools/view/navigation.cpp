// SPDX-License-Identifier: Apache-2.0
#include "view/navigation.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace welkin::view {
namespace {

using f64::Number3;

// GLFW's numbers of keys that are no characters.
constexpr std::size_t kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259, kDelete = 261, kRight = 262,
                      kLeft = 263, kDown = 264, kUp = 265, kHome = 268, kEnd = 269, kF5 = 294, kF12 = 301,
                      kLeftShift = 340, kLeftControl = 341, kRightControl = 345;
constexpr double kDegreesAPixel = 0.2;
constexpr double kPace_m = 6.0;        // a second; with shift four times that
constexpr double kHoursASecond = 0.4;  // of the day that plays
constexpr double kClickPixels = 4.0;   // the mouse may move so far within a click

bool isControl(const WindowInput& input) {
  return input.key[kLeftControl] || input.key[kRightControl];
}

Number3 forwardOf(const Eye& eye) {
  return f64::directionOf(eye.yaw_deg * f64::kDegree, eye.pitch_deg * f64::kDegree);
}

}  // namespace

void mapKeys() {
  ImGuiIO& io = ImGui::GetIO();
  const std::pair<ImGuiKey, std::size_t> map[] = {{ImGuiKey_Tab, kTab},
                                                  {ImGuiKey_LeftArrow, kLeft},
                                                  {ImGuiKey_RightArrow, kRight},
                                                  {ImGuiKey_UpArrow, kUp},
                                                  {ImGuiKey_DownArrow, kDown},
                                                  {ImGuiKey_Home, kHome},
                                                  {ImGuiKey_End, kEnd},
                                                  {ImGuiKey_Delete, kDelete},
                                                  {ImGuiKey_Backspace, kBackspace},
                                                  {ImGuiKey_Enter, kEnter},
                                                  {ImGuiKey_Escape, kEscape},
                                                  {ImGuiKey_A, 'A'},
                                                  {ImGuiKey_C, 'C'},
                                                  {ImGuiKey_V, 'V'},
                                                  {ImGuiKey_X, 'X'},
                                                  {ImGuiKey_Y, 'Y'},
                                                  {ImGuiKey_Z, 'Z'}};
  for (const auto& [own, key] : map) io.KeyMap[own] = static_cast<int>(key);
}

void feedPanels(const WindowInput& input, double seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DeltaTime = static_cast<float>(std::max(seconds, 1e-4));
  io.MousePos = {static_cast<float>(input.x), static_cast<float>(input.y)};
  for (std::size_t i = 0; i < input.button.size(); ++i) io.MouseDown[i] = input.button[i];
  io.MouseWheel = static_cast<float>(input.wheel);
  std::copy(input.key.begin(), input.key.end(), io.KeysDown);
  io.KeyCtrl = isControl(input);
  io.KeyShift = input.key[kLeftShift];
  for (const uint32_t character : input.text) io.AddInputCharacter(character);
}

bool Navigation::pressed(const WindowInput& input, char key) const {
  const auto index = static_cast<std::size_t>(key);
  return input.key[index] && !before_.key[index];
}

void Navigation::move(const Eye& eye) {
  panels_.perform(fmt::format("camera {} {} {} {} {} {}", eye.position.x, eye.position.y, eye.position.z,
                              std::remainder(eye.yaw_deg, 360.0), std::clamp(eye.pitch_deg, -89.0, 89.0), eye.fov_deg));
}

void Navigation::look(const WindowInput& input) {
  const double dx = input.x - before_.x, dy = input.y - before_.y;
  if (input.button[0] && !before_.button[0]) {
    down_x_ = input.x;
    down_y_ = input.y;
    down_on_picture_ = true;
  }
  Eye eye = session_.state().eye;
  if (input.button[1] && before_.button[1] && (dx != 0.0 || dy != 0.0)) {
    eye.yaw_deg += dx * kDegreesAPixel;
    eye.pitch_deg -= dy * kDegreesAPixel;
    move(eye);
  } else if (input.button[2] && before_.button[2] && (dx != 0.0 || dy != 0.0)) {
    const std::optional<baked::SurfacePoint>& point = session_.state().point;
    const Number3 centre = point ? point->position : eye.position + forwardOf(eye) * 10.0;
    const Number3 way = centre - eye.position;
    const double far_m = std::sqrt(dot(way, way));
    eye.yaw_deg = std::atan2(way.x, -way.z) / f64::kDegree + dx * kDegreesAPixel;
    eye.pitch_deg =
        std::clamp(std::atan2(way.y, std::hypot(way.x, way.z)) / f64::kDegree - dy * kDegreesAPixel, -89.0, 89.0);
    eye.position = centre - forwardOf(eye) * far_m;
    move(eye);
  }
  moves_ = moves_ || input.button[1] || input.button[2];
  if (input.wheel == 0.0) return;
  eye.position += session_.rayAt(input.x, input.y) * (input.wheel * 2.0);
  move(eye);
}

void Navigation::walk(const WindowInput& input, double seconds) {
  Eye eye = session_.state().eye;
  const Number3 forward = forwardOf(eye);
  const Number3 right = f64::directionOf(eye.yaw_deg * f64::kDegree + f64::kHalfPi, 0.0);
  Number3 way(0.0);
  const auto add = [&](char key, const Number3& v) {
    if (input.key[static_cast<std::size_t>(key)]) way += v;
  };
  add('W', forward);
  add('S', -forward);
  add('D', right);
  add('A', -right);
  add('E', Number3(0.0, 1.0, 0.0));
  add('Q', Number3(0.0, -1.0, 0.0));
  if (dot(way, way) == 0.0) return;
  const double pace = kPace_m * (input.key[kLeftShift] ? 4.0 : 1.0);
  eye.position += way * (pace * std::min(seconds, 0.25));
  move(eye);
  moves_ = true;
}

void Navigation::keys(const WindowInput& input) {
  if (isControl(input)) {
    if (pressed(input, 'Z')) panels_.perform("undo");
    if (pressed(input, 'Y')) panels_.perform("redo");
    if (pressed(input, 'S')) panels_.perform("save");
    if (pressed(input, 'Q')) quits_ = true;
    return;
  }
  if (pressed(input, ' ')) plays_ = !plays_;
  if (pressed(input, 'O')) panels_.perform("overview");
  if (pressed(input, 'B')) panels_.perform(session_.state().bounds ? "bounds off" : "bounds on");
  if (pressed(input, 'F')) panels_.perform("fly point");
  if (pressed(input, 'P'))
    panels_.perform(session_.state().probes == ProbeShade::off ? "probes irradiance" : "probes off");
  if (pressed(input, 'N')) panels_.perform("probe add here");
  if (pressed(input, 'M')) panels_.perform("probe move selected here");
  if (pressed(input, 'R')) panels_.perform("room corner");
  if (input.key[kDelete] && !before_.key[kDelete]) panels_.perform("probe delete selected");
  if (input.key[kF5] && !before_.key[kF5]) panels_.perform("rebake");
  if (input.key[kF12] && !before_.key[kF12]) panels_.perform("screenshot welkin_view.png");
}

void Navigation::act(const WindowInput& input, double seconds) {
  const ImGuiIO& io = ImGui::GetIO();
  moves_ = false;
  if (!io.WantTextInput) {
    keys(input);
    if (!isControl(input)) walk(input, seconds);
  }
  if (!io.WantCaptureMouse) look(input);
  const bool clicked = !input.button[0] && before_.button[0] && down_on_picture_ &&
                       std::hypot(input.x - down_x_, input.y - down_y_) < kClickPixels;
  if (!input.button[0]) down_on_picture_ = false;
  if (clicked)
    panels_.perform(fmt::format("click {} {}", std::clamp<double>(input.x, 0.0, session_.width()),
                                std::clamp<double>(input.y, 0.0, session_.height())));
  if (plays_) {
    const double hour = session_.state().time_h + kHoursASecond * std::min(seconds, 0.25);
    panels_.perform(fmt::format("time {}", hour - 24.0 * std::floor(hour / 24.0)));
    moves_ = true;
  }
  before_ = input;
}

}  // namespace welkin::view
