// SPDX-License-Identifier: Apache-2.0
#include "sky/image/colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"

namespace welkin::image {

using det::Number3;
namespace {

constexpr double kLargestElement = 1000.0;

Number3 xyzOf(const std::array<double, 2>& xy) {
  return {xy[0], xy[1], 1.0 - xy[0] - xy[1]};
}

std::optional<ColourMatrix> inverse(const ColourMatrix& m) {
  const auto& [a, b, c] = m.column;
  const Number3 row[3] = {cross(b, c), cross(c, a), cross(a, b)};
  const double determinant = dot(a, row[0]);
  if (!(std::abs(determinant) > 1e-9)) return std::nullopt;
  ColourMatrix result;
  for (int i = 0; i < 3; ++i)
    result.column[static_cast<std::size_t>(i)] = Number3(row[0][i], row[1][i], row[2][i]) * (1.0 / determinant);
  return result;
}

ColourMatrix diagonal(const Number3& v) {
  return {{Number3(v.x, 0.0, 0.0), Number3(0.0, v.y, 0.0), Number3(0.0, 0.0, v.z)}};
}

/// XYZ of a white of luminance 1.
Number3 whiteXyz(const std::array<double, 2>& xy) {
  return xyzOf(xy) * (1.0 / xy[1]);
}

}  // namespace

Number3 ColourMatrix::operator*(const Number3& v) const {
  return column[0] * v.x + column[1] * v.y + column[2] * v.z;
}

ColourMatrix ColourMatrix::operator*(const ColourMatrix& m) const {
  return {{*this * m.column[0], *this * m.column[1], *this * m.column[2]}};
}

bool isRec709(const Chromaticities& colours) {
  constexpr double kLastDigit = 1.0001e-4;
  const auto near = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return std::abs(a[0] - b[0]) <= kLastDigit && std::abs(a[1] - b[1]) <= kLastDigit;
  };
  return near(colours.red, kRec709.red) && near(colours.green, kRec709.green) && near(colours.blue, kRec709.blue) &&
         near(colours.white, kRec709.white);
}

std::optional<ColourMatrix> toXyz(const Chromaticities& colours) {
  const ColourMatrix primaries{{xyzOf(colours.red), xyzOf(colours.green), xyzOf(colours.blue)}};
  const auto inverted = inverse(primaries);
  if (!inverted || !(colours.white[1] > 0.0)) return std::nullopt;
  const ColourMatrix result = primaries * diagonal(*inverted * whiteXyz(colours.white));
  for (const Number3& column : result.column)
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(column[i]) <= kLargestElement)) return std::nullopt;
  return result;
}

ColourMatrix rec709OfXyz(const std::array<double, 2>& white) {
  static const ColourMatrix kBradford{
      {Number3(0.8951, -0.7502, 0.0389), Number3(0.2664, 1.7135, -0.0685), Number3(-0.1614, 0.0367, 1.0296)}};
  static const ColourMatrix kBack = *inverse(kBradford);
  static const ColourMatrix kToRgb = *inverse(*toXyz(kRec709));
  const Number3 from = kBradford * whiteXyz(white);
  const Number3 to = kBradford * whiteXyz(kRec709.white);
  return kToRgb * kBack * diagonal(Number3(to.x / from.x, to.y / from.y, to.z / from.z)) * kBradford;
}

std::optional<ColourMatrix> toRec709(const Chromaticities& colours) {
  const auto xyz = toXyz(colours);
  if (!xyz) return std::nullopt;
  const ColourMatrix result = rec709OfXyz(colours.white) * *xyz;
  for (const Number3& column : result.column)
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(column[i]) <= kLargestElement)) return std::nullopt;
  return result;
}

std::string textOf(const Chromaticities& c) {
  return fmt::format("red ({:.4g}, {:.4g}), green ({:.4g}, {:.4g}), blue ({:.4g}, {:.4g}), white ({:.4g}, {:.4g})",
                     c.red[0], c.red[1], c.green[0], c.green[1], c.blue[0], c.blue[1], c.white[0], c.white[1]);
}

void convertColours(const ColourMatrix& matrix, const std::string& of, Image& image) {
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    float* texel = image.rgb.data() + i;
    const Number3 colour = matrix * Number3(double{texel[0]}, double{texel[1]}, double{texel[2]});
    for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(colour[c]);
  }
  image.converted = true;
  image.notes.push_back(fmt::format("colours of {} were converted to Rec. 709", of));
}

void convertColours(const std::string& file, const Chromaticities& colours, Image& image) {
  if (isRec709(colours)) return;
  const auto matrix = toRec709(colours);
  if (!matrix)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: chromaticities that are no colour space: {}", file, textOf(colours)));
  convertColours(*matrix, "the chromaticities " + textOf(colours), image);
}

}  // namespace welkin::image
