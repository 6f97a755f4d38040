// SPDX-License-Identifier: Apache-2.0
#include "render/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>

#include "sky/base/atomic_file.h"
#include "sky/image/image.h"

namespace welkin::render {
namespace {

namespace fs = std::filesystem;

constexpr uint32_t kMostAcross = 4;  // Most single pictures in a row. Columns of several pictures stay side by side.
constexpr uint32_t kMargin = 8;
constexpr uint32_t kLabelHeight = 24;
constexpr int kLabelSize = 18;
constexpr double kLetterWidth = 0.62;  // of DejaVu Sans, mean, of its height

/// Finds a sans-serif font of the system, in the first folder `fonts` of XDG_DATA_DIRS that has one. Empty when there
/// is none.
std::string findFont() {
  const char* variable = std::getenv("XDG_DATA_DIRS");
  std::string folders = variable != nullptr && *variable != '\0' ? variable : "/usr/local/share:/usr/share";
  std::vector<std::string> found;
  for (std::size_t begin = 0; begin <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    std::error_code ignored;
    fs::recursive_directory_iterator it(fs::path(folders.substr(begin, end - begin)) / "fonts",
                                        fs::directory_options::skip_permission_denied, ignored);
    for (; !ignored && it != fs::recursive_directory_iterator(); it.increment(ignored)) {
      const std::string name = it->path().filename().string();
      if (name == "DejaVuSans.ttf") return it->path().string();
      if (name.ends_with("Sans-Regular.ttf")) found.push_back(it->path().string());
    }
    begin = end + 1;
  }
  return found.empty() ? std::string() : *std::min_element(found.begin(), found.end());
}

/// The height of a line of `letters` letters that `room` texels across hold; below 1: none.
int heightOf(std::size_t letters, uint32_t room) {
  return std::min(kLabelSize, static_cast<int>(room / (kLetterWidth * static_cast<double>(letters))));
}

void drawLine(Picture& picture, uint32_t x, uint32_t y, int size, const std::string& text, const std::string& font) {
  if (size < 1) return;
  image::drawCaption(static_cast<int>(picture.width), static_cast<int>(picture.height), picture.rgb,
                     {static_cast<int>(x), static_cast<int>(y), size, text, font});
}

void paste(const Picture& from, Picture& to, uint32_t left, uint32_t top) {
  for (uint32_t y = 0; y < from.height; ++y)
    std::copy_n(from.rgb.data() + std::size_t{3} * y * from.width, std::size_t{3} * from.width,
                to.rgb.data() + std::size_t{3} * ((top + y) * to.width + left));
}

}  // namespace

void drawWords(Picture& picture, uint32_t x, uint32_t y, uint32_t room, const std::string& text) {
  const std::string font = findFont();
  if (!font.empty() && !text.empty()) drawLine(picture, x, y, heightOf(text.size(), room), text, font);
}

Picture contactSheet(const std::vector<SheetColumn>& columns) {
  const std::string font = findFont();
  const uint32_t header = font.empty() ? 0 : kLabelHeight;
  const auto count = static_cast<uint32_t>(columns.size());
  const uint32_t rows = columns.front().pictures.size() == 1 ? (count + kMostAcross - 1) / kMostAcross : 1;
  const uint32_t across = (count + rows - 1) / rows;
  const uint32_t cell_width = columns.front().pictures.front().width + kMargin;
  uint32_t cell_height = header;
  for (const Picture& picture : columns.front().pictures) cell_height += picture.height + kMargin;
  Picture sheet;
  sheet.width = kMargin + across * cell_width;
  sheet.height = kMargin + rows * cell_height;
  sheet.rgb.assign(std::size_t{3} * sheet.width * sheet.height, kGround);
  const auto leftOf = [&](uint32_t i) { return kMargin + i % across * cell_width; };
  const auto topOf = [&](uint32_t i) { return kMargin + i / across * cell_height; };
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t top = topOf(i) + header;
    for (const Picture& picture : columns[i].pictures) {
      paste(picture, sheet, leftOf(i), top);
      top += picture.height + kMargin;
    }
  }
  if (font.empty()) return sheet;

  std::size_t letters = 1;
  for (const SheetColumn& column : columns) letters = std::max(letters, column.label.size());
  for (uint32_t i = 0; i < count; ++i)
    drawLine(sheet, leftOf(i) + (cell_width - kMargin) / 2, topOf(i) + header / 2, heightOf(letters, cell_width),
             columns[i].label, font);
  return sheet;
}

std::string clockLabel(double time_h) {
  const int minutes = static_cast<int>(std::lround(time_h * 60.0)) % (24 * 60);
  char text[8];
  std::snprintf(text, sizeof(text), "%02d:%02d", minutes / 60, minutes % 60);
  return text;
}

void writePng(const Picture& picture, const std::string& path) {
  const std::span<const uint8_t> rgb(picture.rgb);
  base::writeFile(path, image::encodePng(static_cast<int>(picture.width), static_cast<int>(picture.height), rgb));
}

}  // namespace welkin::render
