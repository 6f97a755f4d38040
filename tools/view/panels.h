// SPDX-License-Identifier: Apache-2.0
// The panels over the picture. They show the session, and change it by commands alone (actions.h).
#pragma once

#include <string>

#include "view/session.h"

struct ImDrawData;
struct ImGuiContext;

namespace welkin::view {

class Panels {
 public:
  /// Makes an ImGui context and makes it the current one.
  explicit Panels(Session& session);
  ~Panels();
  Panels(const Panels&) = delete;
  Panels& operator=(const Panels&) = delete;

  /// Lays the panels out for a picture of the session's size. The result is valid until the next call.
  const ImDrawData& build();
  /// The same, until the layout has come to rest.
  const ImDrawData& settled();

  /// Performs a command; a complaint is shown until the next command.
  void perform(const std::string& line);
  /// Shows a complaint until the next command.
  void complain(const std::string& text) { complaint_ = text; }

 private:
  void time();
  void see();
  void change();
  void compare();
  void point();
  void probe();
  void edit();
  void warnings();
  void cost();
  void help();
  /// Performs a change of the light. All of one drag of a slider are one step of undo.
  void performDragged(const std::string& line);

  Session& session_;
  ImGuiContext* context_;
  std::string complaint_;
  int curve_ = 0;
  std::size_t dragged_step_ = 0;  ///< undoCount() after the last change by the slider that is dragged; 0: none yet
};

}  // namespace welkin::view
