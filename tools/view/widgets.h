// SPDX-License-Identifier: Apache-2.0
// Pieces of the panels: lines of text, choices and sliders of one width.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <string>

#include "baked/level_folder.h"

namespace welkin::view {

/// Text that is never a format.
void say(const std::string& text);

bool header(const char* name, bool open = true);

/// A choice among `count` names; the chosen index, or -1 if nothing was clicked.
int choice(const char* label, const char* const* names, std::size_t count, std::size_t now);
template <std::size_t N>
int choice(const char* label, const char* const (&names)[N], std::size_t now) {
  return choice(label, names, N, now);
}

/// From 0 to `high`. Returns whether it was moved, and `value` where it stands.
bool slider(const char* label, double now, float high, float& value);

std::string rgbText(const f64::Number3& v);
std::string rgbText(const Float3& v);

/// A name and, in a column of its own, a text.
void row(const char* name, const std::string& text);

}  // namespace welkin::view
