// SPDX-License-Identifier: Apache-2.0
#include "view/quick_tone.h"

#include <tbb/parallel_for.h>

#include <array>
#include <bit>
#include <cstdint>

#include "shared.h"

namespace welkin::view {
namespace {

// The table has 256 entries an octave, by the first bits of a float, and is linear between them.
constexpr int kBits = 8, kDropped = 23 - kBits;
constexpr float kLeast = 0x1p-24F, kMost = 0x1p7F;  // below, a code is under 1e-3; above, it is 255
constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kLeast) >> kDropped;
constexpr std::size_t kEntries = (std::bit_cast<std::uint32_t>(kMost) >> kDropped) - kFirst + 1;
constexpr std::uint32_t kFraction = (1U << kDropped) - 1;

struct ToneTable {
  std::array<float, kEntries> code{};
  std::array<std::array<float, 8>, 8> dither{};  // plus one half, for rounding

  ToneTable() {
    for (std::size_t i = 0; i < kEntries; ++i) {
      const auto x = std::bit_cast<float>((kFirst + static_cast<std::uint32_t>(i)) << kDropped);
      code[i] = static_cast<float>(255.0 * f64::srgbEncode(render::filmic(double{x})));
    }
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        dither[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
            static_cast<float>(f64::ditherAt(x, y) + 0.5);
  }

  float at(float x) const {
    if (x >= kMost) return 255.0F;
    if (!(x > kLeast)) return 0.0F;  // NaN becomes black
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const std::size_t i = (bits >> kDropped) - kFirst;
    const float share = static_cast<float>(bits & kFraction) * (1.0F / (kFraction + 1));
    return code[i] + (code[i + 1] - code[i]) * share;
  }
};

}  // namespace

render::Picture quickTone(const render::FloatImage& image, double exposure) {
  static const ToneTable table;
  render::Picture picture{image.width, image.height,
                          std::vector<std::uint8_t>(std::size_t{3} * image.width * image.height)};
  const auto factor = static_cast<float>(exposure);
  tbb::parallel_for(std::uint32_t{0}, image.height, [&](std::uint32_t y) {
    std::uint8_t* out = picture.rgb.data() + std::size_t{3} * image.width * y;
    const auto& dither = table.dither[y % 8];
    for (std::uint32_t x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const float radiance = image.pixel(x, y)[c];
        const float code = table.at(radiance * factor);
        const float rounded = code + (radiance > 0.0F ? dither[x % 8] : 0.5F);
        *out++ = static_cast<std::uint8_t>(rounded < 0.0F ? 0.0F : rounded > 255.0F ? 255.0F : rounded);
      }
  });
  return picture;
}

}  // namespace welkin::view
