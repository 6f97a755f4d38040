// SPDX-License-Identifier: Apache-2.0
#include "gloss/block_texture.h"

#include <stb_dxt.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sh/deterministic.h"

namespace welkin::gloss {
namespace {

using det::Number3;

/// Texels of a block, by their place in a mip.
using Place = std::array<std::size_t, 16>;

Place placeOf(const Mip& mip, int block_column, int block_row) {
  Place place;
  for (int i = 0; i < 16; ++i) {
    const int column = std::min(4 * block_column + i % 4, mip.width - 1);
    const int row = std::min(4 * block_row + i / 4, mip.height - 1);
    place[static_cast<std::size_t>(i)] =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(mip.width) + static_cast<std::size_t>(column);
  }
  return place;
}

unsigned char codeOf(double share) {
  return static_cast<unsigned char>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

unsigned char axisCode(const Mip& mip, std::size_t texel, std::size_t axis) {
  return codeOf((double{mip.normal[3 * texel + axis]} + 1.0) / 2.0);
}

/// Sums of squared errors.
struct Squares {
  double y = 0.0, angle = 0.0, most = 0.0, gloss = 0.0;

  void add(const Squares& other) {
    y += other.y;
    angle += other.angle;
    most = std::max(most, other.most);
    gloss += other.gloss;
  }
  void addNormal(const Mip& mip, std::size_t texel, double x_share, double y_share) {
    const float* n = mip.normal.data() + 3 * texel;
    const Number3 expected{double{n[0]}, double{n[1]}, double{n[2]}};
    const double right = 2.0 * x_share - 1.0, up = 2.0 * y_share - 1.0;
    Number3 shown{right, up, std::sqrt(std::max(1.0 - right * right - up * up, 0.0))};
    shown = shown / std::sqrt(dot(shown, shown));
    const Number3 across = cross(expected, shown);
    const double degrees = det::atan(std::sqrt(dot(across, across)), dot(expected, shown)) / det::kDegree;
    y += (up - expected.y) * (up - expected.y);
    angle += degrees * degrees;
    most = std::max(most, degrees);
  }
  void addGloss(const Mip& mip, std::size_t texel, double shown) {
    const double away = shown - double{mip.gloss[texel]};
    gloss += away * away;
  }
};

/// Packs every mip. pack(mip, place, to) writes a block of `bytes` bytes; judge(mip, place, block, i, squares) adds the
/// error of its texel i.
template <typename Pack, typename Judge>
BlockTexture packed(const std::vector<Mip>& mips, std::size_t bytes, Pack&& pack, Judge&& judge) {
  BlockTexture texture;
  Squares sum;
  double texels = 0.0;
  for (const Mip& mip : mips) {
    const int columns = (mip.width + 3) / 4, rows = (mip.height + 3) / 4;
    std::vector<std::byte> level(bytes * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    std::vector<Squares> row_sum(static_cast<std::size_t>(rows));
    tbb::parallel_for(0, rows, [&](int row) {
      for (int column = 0; column < columns; ++column) {
        const Place place = placeOf(mip, column, row);
        std::byte* const block = level.data() + bytes * static_cast<std::size_t>(row * columns + column);
        pack(mip, place, reinterpret_cast<unsigned char*>(block));
        const auto inside = [&](int i) { return 4 * column + i % 4 < mip.width && 4 * row + i / 4 < mip.height; };
        judge(mip, place, block, inside, row_sum[static_cast<std::size_t>(row)]);
      }
    });
    for (const Squares& s : row_sum) sum.add(s);
    texels += static_cast<double>(mip.width) * static_cast<double>(mip.height);
    texture.levels.push_back(std::move(level));
  }
  texture.error = {std::sqrt(sum.y / texels), std::sqrt(sum.angle / texels), sum.most, std::sqrt(sum.gloss / texels)};
  return texture;
}

}  // namespace

BlockTexture packBc3(const std::vector<Mip>& mips, std::optional<double> one_gloss) {
  return packed(
      mips, 16,
      [&](const Mip& mip, const Place& place, unsigned char* to) {
        std::array<unsigned char, 64> rgba;
        for (std::size_t i = 0; i < 16; ++i) {
          rgba[4 * i] = codeOf(one_gloss ? *one_gloss : double{mip.gloss[place[i]]});
          rgba[4 * i + 1] = axisCode(mip, place[i], 1);
          rgba[4 * i + 2] = 0;
          rgba[4 * i + 3] = axisCode(mip, place[i], 0);
        }
        stb_compress_dxt_block(to, rgba.data(), 1, STB_DXT_HIGHQUAL);
      },
      [](const Mip& mip, const Place& place, const std::byte* block, auto&& inside, Squares& squares) {
        const std::vector<double> alpha = decodeBc4(block);
        const std::vector<RedGreen> colour = decodeBc3Colours(block + 8);
        for (std::size_t i = 0; i < 16; ++i) {
          if (!inside(static_cast<int>(i))) continue;
          squares.addNormal(mip, place[i], alpha[i], colour[i].green);
          squares.addGloss(mip, place[i], colour[i].red);
        }
      });
}

BlockTexture packBc5(const std::vector<Mip>& mips) {
  return packed(
      mips, 16,
      [](const Mip& mip, const Place& place, unsigned char* to) {
        std::array<unsigned char, 32> rg;
        for (std::size_t i = 0; i < 16; ++i)
          for (std::size_t c = 0; c < 2; ++c) rg[2 * i + c] = axisCode(mip, place[i], c);
        stb_compress_bc5_block(to, rg.data());
      },
      [](const Mip& mip, const Place& place, const std::byte* block, auto&& inside, Squares& squares) {
        const std::vector<double> x = decodeBc4(block), y = decodeBc4(block + 8);
        for (std::size_t i = 0; i < 16; ++i)
          if (inside(static_cast<int>(i))) squares.addNormal(mip, place[i], x[i], y[i]);
      });
}

BlockTexture packBc4(const std::vector<Mip>& mips) {
  return packed(
      mips, 8,
      [](const Mip& mip, const Place& place, unsigned char* to) {
        std::array<unsigned char, 16> red;
        for (std::size_t i = 0; i < 16; ++i) red[i] = codeOf(double{mip.gloss[place[i]]});
        stb_compress_bc4_block(to, red.data());
      },
      [](const Mip& mip, const Place& place, const std::byte* block, auto&& inside, Squares& squares) {
        const std::vector<double> red = decodeBc4(block);
        for (std::size_t i = 0; i < 16; ++i)
          if (inside(static_cast<int>(i))) squares.addGloss(mip, place[i], red[i]);
      });
}

}  // namespace welkin::gloss
