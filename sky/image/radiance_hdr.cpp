// SPDX-License-Identifier: Apache-2.0
#include "sky/image/radiance_hdr.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sky/image/colour.h"
#include "sky/image/image_header.h"
#include "sky/image/orientation.h"
#include "sky/image/pixel_aspect.h"
#include "sky/image/text_reader.h"

namespace welkin::image {
namespace {

struct Header {
  bool xyz = false;
  std::array<double, 3> scale = {1.0, 1.0, 1.0};  ///< product of all exposures and colour corrections
  std::optional<Chromaticities> primaries;
  double pixel_height = 1.0;           ///< over its width: the product of all PIXASPECT
  bool view = false;                   ///< whether VIEW says where the camera stood and looked
  std::int64_t length = 0, lines = 0;  ///< of a line in texels, and their number
  Orientation orientation;
};

class RadianceReader : public TextReader {
 public:
  using TextReader::TextReader;

  Header header();
  /// Reads one line of texels into four planes: three mantissas and the exponents.
  void line(std::size_t length, std::vector<std::uint8_t>& planes);

 private:
  std::string_view textLine() {
    const std::size_t end = text_.find('\n');
    if (end == std::string_view::npos) throw refusal("damaged or cut: the header does not end");
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
  std::uint8_t next() {
    if (text_.empty()) throw refusal("damaged or cut: the file ends before the last texel");
    const auto byte = static_cast<std::uint8_t>(text_.front());
    text_.remove_prefix(1);
    return byte;
  }
  template <std::size_t N>
  std::array<double, N> numbers(std::string_view key, std::string_view text) const;
  void field(std::string_view line, Header& header) const;
  void resolution(std::string_view line, Header& header) const;
  void runs(std::size_t length, std::uint8_t* plane);
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

template <std::size_t N>
std::array<double, N> RadianceReader::numbers(std::string_view key, std::string_view text) const {
  std::array<double, N> value{};
  std::string_view rest = text;
  for (double& v : value) {
    rest = trimmed(rest);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), v);
    if (error != std::errc() || !std::isfinite(v)) throw refusal(fmt::format("{} is not {} finite numbers", key, N));
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  if (!trimmed(rest).empty()) throw refusal(fmt::format("{} is not {} finite numbers", key, N));
  return value;
}

/// Reads one line of the header. Lines that start with a tab are of an earlier picture.
void RadianceReader::field(std::string_view line, Header& header) const {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return;
  const std::string_view key = line.substr(0, equals), value = trimmed(line.substr(equals + 1));
  const auto scale = [&](const std::array<double, 3>& factor) {
    for (std::size_t c = 0; c < 3; ++c) {
      header.scale[c] *= factor[c];
      if (!(factor[c] > 0.0) || !(header.scale[c] >= 1e-30) || !(header.scale[c] <= 1e30))
        throw refusal(
            fmt::format("{} is {}; numbers above 0, and products of 1e-30 to 1e+30, are allowed", key, factor[c]));
    }
  };
  if (key == "FORMAT") {
    if (value != "32-bit_rle_rgbe" && value != "32-bit_rle_xyze")
      throw refusal("FORMAT is neither 32-bit_rle_rgbe nor 32-bit_rle_xyze");
    header.xyz = value == "32-bit_rle_xyze";
  } else if (key == "EXPOSURE") {
    const double exposure = numbers<1>(key, value)[0];
    scale({exposure, exposure, exposure});
  } else if (key == "COLORCORR") {
    scale(numbers<3>(key, value));
  } else if (key == "PRIMARIES") {
    const auto p = numbers<8>(key, value);
    header.primaries = Chromaticities{{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}, {p[6], p[7]}};
  } else if (key == "PIXASPECT") {
    header.pixel_height *= numbers<1>(key, value)[0];
    if (!(header.pixel_height >= 1e-6) || !(header.pixel_height <= 1e6))
      throw refusal(fmt::format("PIXASPECT is {}; products of 1e-6 to 1e+6 are allowed", value));
  } else if (key == "VIEW") {
    header.view = true;
  } else if (key == "GAMMA" && numbers<1>(key, value)[0] != 1.0) {
    throw refusal("GAMMA is not 1; Radiance's values are linear");
  }
}

/// Reads "-Y 32 +X 64" and its seven turns and mirrors. The first axis counts the lines.
void RadianceReader::resolution(std::string_view line, Header& header) const {
  std::string_view rest = line;
  bool axis_seen[2] = {false, false};
  for (std::int64_t* count : {&header.lines, &header.length}) {
    rest = trimmed(rest);
    if (rest.size() < 3 || (rest[0] != '+' && rest[0] != '-') || (rest[1] != 'X' && rest[1] != 'Y'))
      throw refusal("damaged or cut: the order of the texels is missing, such as -Y 32 +X 64");
    const bool plus = rest[0] == '+', y = rest[1] == 'Y';
    axis_seen[y] = true;
    (y ? header.orientation.up : header.orientation.left) = plus == y;
    if (count == &header.lines) header.orientation.columns = !y;
    rest = trimmed(rest.substr(2));
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), *count);
    if (error != std::errc()) throw refusal("damaged or cut: the number of texels is missing");
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  if (!axis_seen[0] || !axis_seen[1] || !trimmed(rest).empty())
    throw refusal("damaged or cut: the order of the texels names an axis twice, or more than two");
}

Header RadianceReader::header() {
  Header header;
  textLine();  // "#?RADIANCE", "#?RGBE"
  for (std::string_view line = textLine(); !line.empty(); line = textLine()) field(line, header);
  resolution(textLine(), header);
  return header;
}

/// One plane of a line by runs: above 128, so many times one byte; else that many bytes.
void RadianceReader::runs(std::size_t length, std::uint8_t* plane) {
  for (std::size_t at = 0; at < length;) {
    const std::size_t code = next();
    const bool run = code > 128;
    const std::size_t count = run ? code - 128 : code;
    if (count == 0 || count > length - at) throw refusal("damaged: a run of texels passes the end of its line");
    const std::uint8_t value = run ? next() : 0;
    for (std::size_t i = 0; i < count; ++i) plane[at++] = run ? value : next();
  }
}

void RadianceReader::line(std::size_t length, std::vector<std::uint8_t>& planes) {
  if (text_.size() < 4) throw refusal("damaged or cut: the file ends before the last texel");
  const auto byte = [&](std::size_t i) { return std::size_t{static_cast<std::uint8_t>(text_[i])}; };
  if (length >= 8 && length < 32768 && byte(0) == 2 && byte(1) == 2 && byte(2) < 128) {
    if (byte(2) << 8U != (length & 0xff00U) || byte(3) != (length & 0xffU))
      throw refusal("damaged: a line of another length");
    text_.remove_prefix(4);
    for (std::size_t p = 0; p < 4; ++p) runs(length, planes.data() + p * length);
    return;
  }
  // The old code: texels of four bytes. 1, 1, 1, n repeats the last one n times, 256 n the next time in a row.
  unsigned shift = 0;
  for (std::size_t at = 0; at < length;) {
    std::uint8_t texel[4];
    for (std::uint8_t& b : texel) b = next();
    if (texel[0] == 1 && texel[1] == 1 && texel[2] == 1) {
      const std::size_t count = shift > 16 ? length + 1 : std::size_t{texel[3]} << shift;
      if (at == 0 || count > length - at) throw refusal("damaged: a run of texels passes the end of its line");
      for (std::size_t i = 0; i < count; ++i, ++at)
        for (std::size_t p = 0; p < 4; ++p) planes[p * length + at] = planes[p * length + at - 1];
      shift += 8;
      continue;
    }
    for (std::size_t p = 0; p < 4; ++p) planes[p * length + at] = texel[p];
    ++at;
    shift = 0;
  }
}

}  // namespace

Image readRadiance(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  RadianceReader reader(name, bytes);
  const Header header = reader.header();
  requireSize(name, header.length, header.lines, limits);
  const auto length = static_cast<std::size_t>(header.length), lines = static_cast<std::size_t>(header.lines);

  Image image;
  image.width = static_cast<int>(header.length);
  image.height = static_cast<int>(header.lines);
  std::vector<std::uint8_t> planes(4 * length);
  for (std::size_t j = 0; j < lines; ++j) {
    reader.line(length, planes);
    for (std::size_t i = 0; i < length; ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        const int exponent = planes[3 * length + i];
        const double mantissa = planes[c * length + i] + 0.5;  // the middle of the step: writers round down
        const double value = exponent == 0 ? 0.0 : std::ldexp(mantissa, exponent - 136) / header.scale[c];
        image.rgb.push_back(static_cast<float>(value));  // grows with the lines that are there
      }
  }
  if (header.scale != std::array{1.0, 1.0, 1.0})
    image.notes.push_back(fmt::format("values were divided by EXPOSURE and COLORCORR, together {:.6g} {:.6g} {:.6g}",
                                      header.scale[0], header.scale[1], header.scale[2]));
  notePixelAspect("PIXASPECT", 1.0 / header.pixel_height, image);
  if (header.view) image.notes.push_back("VIEW is not read; the layout alone says where texels lie");
  if (header.xyz)
    convertColours(rec709OfXyz(kRec709.white), "CIE XYZ (FORMAT=32-bit_rle_xyze)", image);
  else if (header.primaries)
    convertColours(name, *header.primaries, image);
  turnUpright(header.orientation, image);
  return image;
}

}  // namespace welkin::image
