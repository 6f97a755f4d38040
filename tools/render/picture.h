// SPDX-License-Identifier: Apache-2.0
// Contact sheets, labels and PNG files.
#pragma once

#include <string>
#include <vector>

#include "render/tone.h"

namespace welkin::render {

constexpr uint8_t kGround = 24;  ///< grey between pictures and behind words

/// Draws a line of light grey words centred on (x, y), as large as `room` texels across hold, 18 high at most. Without
/// a font in the system it draws nothing.
void drawWords(Picture& picture, uint32_t x, uint32_t y, uint32_t room, const std::string& text);

/// A column of a contact sheet: a label and pictures from the top. All columns have the same shape.
struct SheetColumn {
  std::string label;
  std::vector<Picture> pictures;
};

/// Lays the columns side by side on a dark ground. Columns of one picture wrap after four. Labels are left out when the
/// system has no font.
Picture contactSheet(const std::vector<SheetColumn>& columns);

/// The text of an hour in [0, 24), such as "06:30", to the nearest minute.
std::string clockLabel(double time_h);

/// Writes a PNG file whole or not at all. Throws Error(file).
void writePng(const Picture& picture, const std::string& path);

}  // namespace welkin::render
