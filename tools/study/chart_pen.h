// SPDX-License-Identifier: Apache-2.0
// What a chart is drawn with: lines, words and markers, by cairo, on an SVG, on pixels, or only to learn their extent.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "study/label_layout.h"

namespace welkin::study {

struct Colour {
  double red;
  double green;
  double blue;
};

constexpr Colour kInk = {0.13, 0.13, 0.13};
constexpr Colour kGrey = {0.42, 0.42, 0.42};
constexpr Colour kGrid = {0.90, 0.90, 0.90};

enum class Anchor { left, middle, right };

/// A corner of a line, in pixels.
struct Corner {
  double x;
  double y;
};

/// Colour and marker of the i-th series: pairs repeat after 56.
Colour colourOf(std::size_t series);

class Pen {
 public:
  enum class Target {
    extent,  ///< draws nothing, knows the extent of the ink
    svg,
    png,
  };

  /// A white picture. Throws Error(internal) with cairo's words when it has no memory.
  Pen(Target target, int width, int height);
  Pen(const Pen&) = delete;  // cairo writes to bytes_
  Pen& operator=(const Pen&) = delete;

  void line(const std::vector<Corner>& corners, const Colour& colour, double width, bool dashed = false);
  void marker(std::size_t series, const Corner& at, double radius);
  void ring(const Corner& at, double radius, const Colour& colour);

  /// Words whose middle height is at `at`; clockwise by -90 degrees when `upwards`. DejaVu Sans.
  void text(const std::string& words, const Corner& at, Anchor anchor, double size, const Colour& colour = kInk,
            bool bold = false, bool upwards = false);

  /// The same on a patch of the background that lets lines below shine through.
  void label(const std::string& words, const Box& box, double size);

  double textWidth(const std::string& words, double size, bool bold = false);

  /// Everything between the two is drawn within the box only.
  void beginClip(const Box& box);
  void endClip();

  /// Extent of all ink, in pixels, also of what would lie outside the picture; for Target::extent.
  Box ink() const;

  /// Ends the drawing and returns the bytes of the picture. Throws Error(internal) with cairo's words when it failed.
  std::string finish();

 private:
  void setColour(const Colour& colour, double opacity = 1.0);
  void setFont(double size, bool bold);

  Target target_;
  std::string bytes_;  // of an SVG, as cairo writes it
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

}  // namespace welkin::study
