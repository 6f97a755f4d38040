// SPDX-License-Identifier: Apache-2.0
#include "picture/pen.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <numbers>

#include "sky/base/error.h"

namespace welkin::picture {
namespace {

// Okabe and Ito, "Color Universal Design" (2008), without yellow, which is too light on white.
constexpr std::array<Colour, 7> kColours = {{{0.0, 0.447, 0.698},
                                             {0.835, 0.369, 0.0},
                                             {0.0, 0.620, 0.451},
                                             {0.80, 0.475, 0.655},
                                             {0.902, 0.624, 0.0},
                                             {0.337, 0.706, 0.914},
                                             {0.35, 0.35, 0.35}}};

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw base::Error(base::ExitStatus::internal,
                      fmt::format("picture: cairo says: {}", cairo_status_to_string(status)));
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Colour colourOf(std::size_t index) {
  return kColours[index % kColours.size()];
}

Pen::Pen(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), &cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), &cairo_destroy) {
  setColour({1.0, 1.0, 1.0});
  cairo_paint(cairo_.get());
  cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
  check(cairo_status(cairo_.get()));
}

void Pen::setColour(const Colour& colour) {
  cairo_set_source_rgb(cairo_.get(), colour.red, colour.green, colour.blue);
}

void Pen::line(const std::vector<Corner>& corners, const Colour& colour, double width, bool dashed) {
  for (const Corner& corner : corners) cairo_line_to(cairo_.get(), corner.x, corner.y);
  constexpr std::array<double, 2> kDashes = {5.0, 4.0};
  cairo_set_dash(cairo_.get(), kDashes.data(), dashed ? 2 : 0, 0.0);
  cairo_set_line_width(cairo_.get(), width);
  setColour(colour);
  cairo_stroke(cairo_.get());
}

void Pen::fill(const std::vector<Corner>& corners, const Colour& colour) {
  for (const Corner& corner : corners) cairo_line_to(cairo_.get(), corner.x, corner.y);
  cairo_close_path(cairo_.get());
  setColour(colour);
  cairo_fill(cairo_.get());
}

void Pen::picture(const Pixels& pixels, const Corner& left_top, double scale) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> from(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height), &cairo_surface_destroy);
  check(cairo_surface_status(from.get()));
  unsigned char* to = cairo_image_surface_get_data(from.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(from.get()));
  const auto width = static_cast<std::size_t>(pixels.width);
  for (std::size_t i = 0; i < width * static_cast<std::size_t>(pixels.height); ++i) {
    const std::uint8_t* rgb = pixels.rgb.data() + 3 * i;
    const std::uint32_t word = std::uint32_t{rgb[0]} << 16U | std::uint32_t{rgb[1]} << 8U | std::uint32_t{rgb[2]};
    std::memcpy(to + i / width * stride + 4 * (i % width), &word, sizeof word);
  }
  cairo_surface_mark_dirty(from.get());
  cairo_save(cairo_.get());
  cairo_translate(cairo_.get(), left_top.x, left_top.y);
  cairo_scale(cairo_.get(), scale, scale);
  cairo_set_source_surface(cairo_.get(), from.get(), 0.0, 0.0);
  cairo_paint(cairo_.get());
  cairo_restore(cairo_.get());
}

void Pen::ring(const Corner& at, double radius, const Colour& colour) {
  cairo_arc(cairo_.get(), at.x, at.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_set_dash(cairo_.get(), nullptr, 0, 0.0);
  cairo_set_line_width(cairo_.get(), 1.5);
  setColour(colour);
  cairo_stroke(cairo_.get());
}

std::string Pen::finish() {
  check(cairo_status(cairo_.get()));
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface_.get(), &append, &bytes));
  return bytes;
}

}  // namespace welkin::picture
