// SPDX-License-Identifier: Apache-2.0
#include "picture/digits.h"

#include <array>

namespace welkin::picture {
namespace {

// Bits of the segments: top, upper right, lower right, bottom, lower left, upper left, middle.
constexpr std::array<unsigned, 10> kSegments = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F};

// Ends of the segments in widths and half heights of a digit.
constexpr std::array<std::array<Corner, 2>, 7> kEnds = {{{{{0, 0}, {1, 0}}},
                                                         {{{1, 0}, {1, 1}}},
                                                         {{{1, 1}, {1, 2}}},
                                                         {{{0, 2}, {1, 2}}},
                                                         {{{0, 1}, {0, 2}}},
                                                         {{{0, 0}, {0, 1}}},
                                                         {{{0, 1}, {1, 1}}}}};

constexpr double kWidth = 0.5, kGap = 0.25;  ///< of the height
constexpr double kDot = 0.1;                 ///< length of a dot, of the height

double stepOf(char c, double height) {
  return height * (c == '.' ? kDot + kGap : kWidth + kGap);
}

}  // namespace

double widthOf(std::string_view text, double height) {
  double width = 0.0;
  for (const char c : text) width += stepOf(c, height);
  return text.empty() ? 0.0 : width - kGap * height;
}

std::vector<std::vector<Corner>> linesOf(std::string_view text, const Corner& at, double height) {
  std::vector<std::vector<Corner>> lines;
  double x = at.x;
  for (const char c : text) {
    if (c == '.') lines.push_back({{x, at.y + height}, {x + kDot * height, at.y + height}});
    if (c >= '0' && c <= '9')
      for (std::size_t i = 0; i < kEnds.size(); ++i)
        if (((kSegments[static_cast<std::size_t>(c - '0')] >> i) & 1U) != 0U) {
          const auto end = [&](const Corner& e) {
            return Corner{x + kWidth * height * e.x, at.y + 0.5 * height * e.y};
          };
          lines.push_back({end(kEnds[i][0]), end(kEnds[i][1])});
        }
    x += stepOf(c, height);
  }
  return lines;
}

}  // namespace welkin::picture
