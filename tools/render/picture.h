// SPDX-License-Identifier: Apache-2.0
// Contact sheets, labels and PNG files.
#pragma once

#include <string>
#include <vector>

#include "render/tone.h"

namespace welkin::render {

/// A column of a contact sheet: pictures from the top, all columns alike, under a label.
struct SheetColumn {
  std::string label;
  std::vector<Picture> pictures;
};

/// Lays the columns side by side on a dark ground; columns of one picture wrap after four. Labels are left out when the
/// system has no font.
Picture contactSheet(const std::vector<SheetColumn>& columns);

/// "06:30" of an hour in [0, 24), to the nearest minute.
std::string clockLabel(double time_h);

/// Writes a PNG that is there whole or not at all. Throws Error(file).
void writePng(const Picture& picture, const std::string& path);

}  // namespace welkin::render
