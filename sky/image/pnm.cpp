// SPDX-License-Identifier: Apache-2.0
#include "sky/image/pnm.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "sh/deterministic.h"
#include "sky/image/image_header.h"
#include "sky/image/text_reader.h"

namespace welkin::image {
namespace {

bool isSpace(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

class PnmReader : public TextReader {
 public:
  using TextReader::TextReader;

  /// Reads the word that stands after spaces and comments.
  std::string_view word() {
    while (!text_.empty() && (isSpace(text_[0]) || text_[0] == '#'))
      text_.remove_prefix(text_[0] == '#' ? std::min(text_.find('\n'), text_.size()) : 1);
    const auto end = std::find_if(text_.begin(), text_.end(), [](char c) { return isSpace(c) || c == '#'; });
    const std::string_view word = text_.substr(0, static_cast<std::size_t>(end - text_.begin()));
    if (word.empty()) throw refusal("damaged or cut: the file ends before the last texel");
    text_.remove_prefix(word.size());
    return word;
  }

  template <typename Number>
  Number number(const char* of) {
    const std::string_view text = word();
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) throw refusal(fmt::format("{} is no number", of));
    return value;
  }

  /// The bytes of the texels, after the one space that ends the header.
  std::string_view texels(std::size_t size) {
    if (text_.size() < size + 1 || !isSpace(text_[0]))
      throw refusal(
          fmt::format("damaged or cut: {} bytes of texels are missing", size + 1 - std::min(size, text_.size())));
    return text_.substr(1, size);
  }
};

std::uint32_t bigEndian(const char* p, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) value = value << 8U | static_cast<unsigned char>(p[i]);
  return value;
}

/// The floats' rows go from the bottom.
void readFloats(PnmReader& reader, int channels, Image& image) {
  const auto scale = reader.number<double>("the scale");
  const double factor = std::abs(scale);
  if (!(factor >= 1e-30 && factor <= 1e30)) throw reader.refusal("the scale is not 1e-30 to 1e+30, of either sign");
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  const auto n = static_cast<std::size_t>(channels);
  const std::string_view bytes = reader.texels(width * height * n * 4);
  image.rgb.resize(3 * width * height);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const std::size_t row = height - 1 - i / 3 / width, column = i / 3 % width;
    char raw[4];
    std::memcpy(raw, bytes.data() + 4 * ((row * width + column) * n + (n == 1 ? 0 : i % 3)), 4);
    if (scale < 0.0) std::reverse(raw, raw + 4);
    image.rgb[i] = static_cast<float>(double{std::bit_cast<float>(bigEndian(raw, 4))} * factor);
  }
  if (factor != 1.0) image.notes.push_back(fmt::format("values were multiplied by the scale {:.6g}", factor));
}

void readCodes(PnmReader& reader, bool text, int channels, bool linear, Image& image) {
  const auto largest = reader.number<std::int64_t>("the largest value");
  if (largest < 1 || largest > 65535)
    throw reader.refusal(fmt::format("the largest value is {}; 1 to 65535 are allowed", largest));
  const std::size_t texels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const auto n = static_cast<std::size_t>(channels);
  const int size = largest > 255 ? 2 : 1;
  const std::string_view bytes = text ? "" : reader.texels(texels * n * static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < texels; ++i) {
    float value[3];
    for (std::size_t c = 0; c < n; ++c) {
      const auto code =
          text ? reader.number<std::int64_t>("a texel")
               : std::int64_t{bigEndian(bytes.data() + (i * n + c) * static_cast<std::size_t>(size), size)};
      if (code < 0 || code > largest)
        throw reader.refusal(fmt::format("a texel is {}; 0 to {} are allowed", code, largest));
      const double part = static_cast<double>(code) / static_cast<double>(largest);
      value[c] = static_cast<float>(linear ? part : det::srgbDecode(part));
    }
    if (n == 1) value[1] = value[2] = value[0];
    image.rgb.insert(image.rgb.end(), value, value + 3);
  }
}

}  // namespace

Image readPnm(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  PnmReader reader(name, bytes);
  const std::string_view magic = reader.word();
  if (magic.size() != 2) throw reader.refusal("damaged: two characters name the format");
  const auto width = reader.number<std::int64_t>("the width"), height = reader.number<std::int64_t>("the height");
  requireSize(name, width, height, limits);
  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  const int channels = magic == "P3" || magic == "P6" || magic == "PF" ? 3 : 1;
  if (magic == "PF" || magic == "Pf")
    readFloats(reader, channels, image);
  else
    readCodes(reader, magic == "P2" || magic == "P3", channels, limits.linear_codes, image);
  return image;
}

}  // namespace welkin::image
