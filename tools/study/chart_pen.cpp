// SPDX-License-Identifier: Apache-2.0
#include "study/chart_pen.h"

#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

constexpr const char* kFont = "DejaVu Sans";
constexpr double kMiddleOfText = 0.36;  // of the font's size: half the height of capitals above the baseline

// Okabe and Ito's colours but yellow, which is too light on white.
constexpr std::array<Colour, 7> kColours = {{{0.0, 0.447, 0.698},
                                             {0.835, 0.369, 0.0},
                                             {0.0, 0.620, 0.451},
                                             {0.80, 0.475, 0.655},
                                             {0.902, 0.624, 0.0},
                                             {0.337, 0.706, 0.914},
                                             {0.35, 0.35, 0.35}}};

// Corners of the markers on a circle of radius 1, from the top clockwise; the first marker is the circle itself.
struct Polygon {
  int corners;
  double turn_deg;
};
constexpr std::array<Polygon, 6> kPolygons = {{{4, 45.0}, {3, 0.0}, {4, 0.0}, {3, 180.0}, {5, 0.0}, {6, 30.0}}};
constexpr std::size_t kMarkers = kPolygons.size() + 2;  // and a cross

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw base::Error(base::ExitStatus::internal, fmt::format("chart: cairo says: {}", cairo_status_to_string(status)));
  }
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* newSurface(Pen::Target target, int width, int height, std::string& bytes) {
  switch (target) {
    case Pen::Target::extent:
      return cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr);
    case Pen::Target::svg: {
      cairo_surface_t* const surface = cairo_svg_surface_create_for_stream(&append, &bytes, width, height);
      cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
      return surface;
    }
    case Pen::Target::png:
      return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  }
  return nullptr;
}

// cairo names surfaces by a counter of the process: numbers them by their first appearance instead.
std::string withoutCounters(const std::string& svg) {
  constexpr std::string_view kName = "surface";
  std::vector<std::string> seen;
  std::string text;
  std::size_t from = 0;
  for (std::size_t at = svg.find(kName); at != std::string::npos; at = svg.find(kName, from)) {
    std::size_t end = at + kName.size();
    while (end < svg.size() && std::isdigit(static_cast<unsigned char>(svg[end])) != 0) ++end;
    const std::string number = svg.substr(at + kName.size(), end - at - kName.size());
    auto known = std::ranges::find(seen, number);
    if (known == seen.end()) known = seen.insert(seen.end(), number);
    text.append(svg, from, at + kName.size() - from);
    text += fmt::format("{}", known - seen.begin());
    from = end;
  }
  return text.append(svg, from);
}

}  // namespace

Colour colourOf(std::size_t series) {
  return kColours[series % kColours.size()];
}

Pen::Pen(Target target, int width, int height)
    : target_(target),
      surface_(newSurface(target, width, height, bytes_), &cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), &cairo_destroy) {
  if (target != Target::extent) {
    cairo_set_source_rgb(cairo_.get(), 1.0, 1.0, 1.0);
    cairo_paint(cairo_.get());
  }
  // What fontconfig's settings of a machine would change.
  const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
      cairo_font_options_create(), &cairo_font_options_destroy);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo_.get(), options.get());
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
  check(cairo_status(cairo_.get()));
}

void Pen::setColour(const Colour& colour, double opacity) {
  cairo_set_source_rgba(cairo_.get(), colour.red, colour.green, colour.blue, opacity);
}

void Pen::setFont(double size, bool bold) {
  cairo_select_font_face(cairo_.get(), kFont, CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_.get(), size);
}

void Pen::line(const std::vector<Corner>& corners, const Colour& colour, double width, bool dashed) {
  cairo_new_path(cairo_.get());  // words leave a current point
  for (const Corner& corner : corners) cairo_line_to(cairo_.get(), corner.x, corner.y);
  constexpr std::array<double, 2> kDashes = {5.0, 4.0};
  cairo_set_dash(cairo_.get(), kDashes.data(), dashed ? 2 : 0, 0.0);
  cairo_set_line_width(cairo_.get(), width);
  setColour(colour);
  cairo_stroke(cairo_.get());
  cairo_set_dash(cairo_.get(), nullptr, 0, 0.0);
}

void Pen::ring(const Corner& at, double radius, const Colour& colour) {
  cairo_new_path(cairo_.get());
  cairo_arc(cairo_.get(), at.x, at.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_set_line_width(cairo_.get(), 1.5);
  setColour(colour);
  cairo_stroke(cairo_.get());
}

void Pen::marker(std::size_t series, const Corner& at, double radius) {
  cairo_t* const cairo = cairo_.get();
  const std::size_t kind = series % kMarkers;
  if (kind == kMarkers - 1) {
    const double r = radius * 0.8;
    line({{at.x - r, at.y - r}, {at.x + r, at.y + r}}, colourOf(series), 2.2);
    line({{at.x - r, at.y + r}, {at.x + r, at.y - r}}, colourOf(series), 2.2);
    return;
  }
  cairo_new_path(cairo);
  if (kind == 0) {
    cairo_arc(cairo, at.x, at.y, radius * 0.9, 0.0, 2.0 * std::numbers::pi);
  } else {
    const Polygon& polygon = kPolygons[kind - 1];
    for (int i = 0; i < polygon.corners; ++i) {
      const double turn = (360.0 * i / polygon.corners + polygon.turn_deg - 90.0) * std::numbers::pi / 180.0;
      cairo_line_to(cairo, at.x + 1.15 * radius * std::cos(turn), at.y + 1.15 * radius * std::sin(turn));
    }
  }
  cairo_close_path(cairo);
  setColour(colourOf(series));
  cairo_fill_preserve(cairo);
  setColour({1.0, 1.0, 1.0});  // parts markers that overlap
  cairo_set_line_width(cairo, 0.8);
  cairo_stroke(cairo);
}

double Pen::textWidth(const std::string& words, double size, bool bold) {
  setFont(size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo_.get(), words.c_str(), &extents);
  return extents.x_advance;
}

void Pen::text(const std::string& words, const Corner& at, Anchor anchor, double size, const Colour& colour, bool bold,
               bool upwards) {
  const double width = textWidth(words, size, bold);
  const double back = anchor == Anchor::left ? 0.0 : anchor == Anchor::middle ? width / 2.0 : width;
  cairo_save(cairo_.get());
  cairo_translate(cairo_.get(), at.x, at.y);
  if (upwards) cairo_rotate(cairo_.get(), -std::numbers::pi / 2.0);
  cairo_move_to(cairo_.get(), -back, kMiddleOfText * size);
  setColour(colour);
  cairo_show_text(cairo_.get(), words.c_str());
  cairo_restore(cairo_.get());
}

void Pen::label(const std::string& words, const Box& box, double size) {
  cairo_rectangle(cairo_.get(), box.left - 1.0, box.top, box.right - box.left + 2.0, box.bottom - box.top);
  setColour({1.0, 1.0, 1.0}, 0.8);
  cairo_fill(cairo_.get());
  text(words, {box.left, (box.top + box.bottom) / 2.0}, Anchor::left, size);
}

void Pen::beginClip(const Box& box) {
  cairo_save(cairo_.get());
  cairo_rectangle(cairo_.get(), box.left, box.top, box.right - box.left, box.bottom - box.top);
  cairo_clip(cairo_.get());
}

void Pen::endClip() {
  cairo_restore(cairo_.get());
}

Box Pen::ink() const {
  Box box = {};
  double width = 0.0;
  double height = 0.0;
  cairo_recording_surface_ink_extents(surface_.get(), &box.left, &box.top, &width, &height);
  box.right = box.left + width;
  box.bottom = box.top + height;
  return box;
}

std::string Pen::finish() {
  check(cairo_status(cairo_.get()));
  if (target_ == Target::png) check(cairo_surface_write_to_png_stream(surface_.get(), &append, &bytes_));
  cairo_surface_finish(surface_.get());
  check(cairo_surface_status(surface_.get()));
  return target_ == Target::svg ? withoutCounters(bytes_) : bytes_;
}

}  // namespace welkin::study
