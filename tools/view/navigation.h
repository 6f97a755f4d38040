// SPDX-License-Identifier: Apache-2.0
// Mouse and keys move the camera, pick and call commands.
#pragma once

#include "view/panels.h"
#include "view/window_module.h"

namespace welkin::view {

class Navigation {
 public:
  /// Both must outlive the object.
  Navigation(Session& session, Panels& panels) : session_(session), panels_(panels) {}

  /// Acts on the input, unless panels take it. `seconds` have passed since the last call.
  void act(const WindowInput& input, double seconds);

  /// Whether the picture changes as long as the input stays as it is: keys walk, the mouse drags, the day plays.
  bool moves() const { return moves_; }
  bool quits() const { return quits_; }

 private:
  void look(const WindowInput& input);
  void walk(const WindowInput& input, double seconds);
  void keys(const WindowInput& input);
  void move(const Eye& eye);
  /// Whether the key went down since the last call.
  bool pressed(const WindowInput& input, char key) const;

  Session& session_;
  Panels& panels_;
  WindowInput before_;
  double down_x_ = 0.0, down_y_ = 0.0;  ///< where the left button went down
  bool down_on_picture_ = false;
  bool moves_ = false, plays_ = false, quits_ = false;
};

/// Gives the input to the current ImGui context.
void feedPanels(const WindowInput& input, double seconds);

/// Tells ImGui which of the window's keys edit text.
void mapKeys();

}  // namespace welkin::view
