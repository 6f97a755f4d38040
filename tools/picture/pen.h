// SPDX-License-Identifier: Apache-2.0
// Draws lines and rings into a PNG with cairo.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace welkin::picture {

/// Red, green and blue in [0, 1].
struct Colour {
  double red, green, blue;
};

constexpr Colour kInk = {0.13, 0.13, 0.13};

/// The colour of the i-th of many things. Seven colours repeat; colour-blind people can tell them apart.
Colour colourOf(std::size_t index);

/// A corner of a line, in pixels from the top left.
struct Corner {
  double x, y;
};

/// A picture of 8 bits in sRGB, three bytes a pixel, row by row from the top.
struct Pixels {
  int width, height;
  std::vector<std::uint8_t> rgb;
};

class Pen {
 public:
  /// Starts a white picture; sizes in pixels. Throws Error(internal) with cairo's message if memory runs out.
  Pen(int width, int height);

  void line(const std::vector<Corner>& corners, const Colour& colour, double width, bool dashed = false);
  /// Fills a polygon.
  void fill(const std::vector<Corner>& corners, const Colour& colour);
  /// Draws a picture, `scale` pixels for each of its own.
  void picture(const Pixels& pixels, const Corner& left_top, double scale);
  void ring(const Corner& at, double radius, const Colour& colour);

  /// Ends the drawing and returns the bytes of a PNG. Throws Error(internal) with cairo's message if drawing failed.
  std::string finish();

 private:
  void setColour(const Colour& colour);

  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

}  // namespace welkin::picture
